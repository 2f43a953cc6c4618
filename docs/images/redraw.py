"""Draw again what the pages show of commands and examples: writes the pictures beside this file."""

import runpy
import shutil
from contextlib import chdir
from pathlib import Path
from tempfile import TemporaryDirectory

from swarmgrasp.cli import main

HERE = Path(__file__).parent
EXAMPLES = HERE.parent.parent / "examples"
COMMANDS = {
    "place deck-barge --plot deck-barge.png": ("deck-barge.png", "deck-barge-wrenches.png"),
    "place harbour-tugs --plot harbour-tugs.png": ("harbour-tugs.png",),
    "simulate escort-ring --plot escort-ring-run.png": ("escort-ring-run.png",),
}
"""Pictures of the pages, by the command that writes them."""
OF_EXAMPLES = {
    "barge-together.png": "together.png",
    "sensitivities.png": "sensitivities.png",
    "capability.png": "capability.png",
    "pallet.png": "pallet.png",
}
"""Pictures of the pages, by what the examples call them that write them."""


def redraw() -> None:
    """Draw all of them."""
    with TemporaryDirectory() as folder, chdir(folder):
        for command, names in COMMANDS.items():
            main(command.split())
            for name in names:
                shutil.copy(name, HERE / name)
        for drawn, name in OF_EXAMPLES.items():
            for example in EXAMPLES.glob("*.py"):
                if f'"{drawn}"' in example.read_text("utf-8"):
                    runpy.run_path(str(example), run_name="__main__")
            shutil.copy(drawn, HERE / name)


if __name__ == "__main__":
    redraw()
