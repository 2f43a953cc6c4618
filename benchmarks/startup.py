"""How long it takes to start: the import, and a command on a built-in scenario."""

import subprocess
import sys

from page import Part, digits, duration, table
from timing import Clocked

COMMANDS = {
    '`python -c "import numpy"`': ("-c", "import numpy"),
    '`python -c "import swarmgrasp"`': ("-c", "import swarmgrasp"),
    "`swarmgrasp place deck-barge`": ("-m", "swarmgrasp", "place", "deck-barge"),
}
HEADS = ("command", "time", "times importing NumPy")
TEXT = """## Start-up

Whole processes, warm: each has run before. Medians of {rounds}, in turn.
"""


def measure(args):
    """Measure all commands; return the page's section."""
    rounds = 3 if args.quick else 15
    clocked = {name: Clocked() for name in COMMANDS}
    for turn in range(rounds + 1):
        for name, words in COMMANDS.items():
            clock = clocked[name] if turn else Clocked()  # the first run warms up
            clock.run(
                lambda w=words: subprocess.run(
                    [sys.executable, *w], check=True, capture_output=True
                )
            )
    yardstick = next(iter(clocked.values())).median
    rows = [(n, duration(c.median), digits(c.median / yardstick)) for n, c in clocked.items()]
    for row in rows:
        print("   ", *row, sep="  ", flush=True)
    return Part(TEXT.format(rounds=rounds) + "\n" + table(HEADS, rows))
