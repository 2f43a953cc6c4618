"""Run the command line as ``python -m swarmgrasp``."""

from swarmgrasp.cli import run

if __name__ == "__main__":
    run()
