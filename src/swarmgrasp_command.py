"""The command `swarmgrasp`, from before its first import: Ctrl-C ends it in words at any time."""

import sys
from typing import NoReturn

INTERRUPTED = 130


def run() -> NoReturn:
    """Run the process's command."""
    try:  # the imports take a while, and are interrupted like all else
        from swarmgrasp.cli.app import main

        status = main()
    except KeyboardInterrupt:
        status = INTERRUPTED
    sys.exit(status)
