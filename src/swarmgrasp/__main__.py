"""Run the command line as ``python -m swarmgrasp``."""

import sys

from swarmgrasp.cli import main

if __name__ == "__main__":
    sys.exit(main())
