"""The command line: one file per command, each reads, calls and shows."""

from swarmgrasp.cli.app import main, run

__all__ = ["main", "run"]
