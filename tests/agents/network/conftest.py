import pytest

from swarmgrasp.agents.network.fleet import Fleet
from swarmgrasp.cli import main


@pytest.fixture
def fleet():
    """Run processes that end with the test."""
    with Fleet(main) as fleet:
        yield fleet


@pytest.fixture
def run(capsys):
    """Run a command; return its exit status, what it said, and what it complained about."""

    def run(*arguments):
        status = main([str(argument) for argument in arguments])
        said = capsys.readouterr()
        return status, said.out, said.err

    return run
