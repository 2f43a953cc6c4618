"""Shared modules beside this file can be imported by every test; Hypothesis is repeatable."""

import pytest
from hypothesis import settings

from swarmgrasp.cli import main

settings.register_profile("repeatable", deadline=None, derandomize=True, max_examples=50)
settings.load_profile("repeatable")


@pytest.fixture
def run(capsys):
    """Run a command; return its exit status, what it said, and what it complained about."""

    def run(*arguments):
        status = main([str(argument) for argument in arguments])
        said = capsys.readouterr()
        return status, said.out, said.err

    return run
