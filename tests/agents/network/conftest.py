import pytest

from swarmgrasp.agents.network.fleet import Fleet
from swarmgrasp.cli import main


@pytest.fixture
def fleet():
    """Run processes that end with the test."""
    with Fleet(main) as fleet:
        yield fleet
