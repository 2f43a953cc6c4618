"""What works where the package is installed alone, without an extra."""

import re
import subprocess
import sys
import tomllib
from importlib.metadata import packages_distributions
from pathlib import Path

EXTRAS = tomllib.loads((Path(__file__).parent.parent / "pyproject.toml").read_text("utf-8"))
EXTRAS = EXTRAS["project"]["optional-dependencies"]
ALONE = """
import importlib.util, sys

class Without:
    @staticmethod
    def find_spec(name, path=None, target=None):
        if name.partition(".")[0] in {missing}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)

sys.meta_path.insert(0, Without)
find = importlib.util.find_spec
importlib.util.find_spec = lambda name, *more: None if name in {missing} else find(name, *more)
from swarmgrasp.cli import main
for command in sys.argv[1:]:
    status = main(command.split())
    print("status", status)
"""


def alone(folder, *commands):
    """Run commands, one after the other, as if no extra were there; return what each says."""
    wanted = {re.split(r"[\[<>=]", one)[0] for extra in EXTRAS.values() for one in extra}
    missing = {name for name, of in packages_distributions().items() if wanted & {*of}}
    assert {"duckdb", "mujoco", "msgspec", "pyarrow", "scipy", "starlette", "zenoh"} <= missing
    text = ALONE.format(missing=missing - {"swarmgrasp"})
    done = subprocess.run(
        [sys.executable, "-c", text, *commands], cwd=folder, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return done


def test_what_needs_no_extra_works_without_one(tmp_path):
    """Answers, their proofs and pictures, and runs."""
    done = alone(
        tmp_path,
        "place rectangle-5 --plot place.svg --json answer.json",
        "verify answer.json",
        "simulate model-ship --for 2",
    )
    assert done.stdout.count("status 0\n") == 3
    assert (tmp_path / "place.svg").exists()


def test_a_command_says_which_extra_it_needs(tmp_path):
    """In one line each, as a wrong usage."""
    (tmp_path / "drawing.dxf").write_text("0\nEOF\n")
    said = {
        "study model-ship runs --of gusts --runs 2": "studies",
        "simulate model-ship --log run.parquet": "logs",
        "simulate model-ship --mcap run.mcap": "logs",
        "judge model-ship": "mujoco",
        "studio": "studio",
        "agent rectangle-5 --name A": "agents",
        "agents simulate rectangle-5 --robots 8": "agents",
        "paper report --quick": "paper",
        "convert drawing.dxf barge.yaml": "drawings",
    }
    done = alone(tmp_path, *said)
    assert done.stdout == "status 2\n" * len(said)
    told = [line.partition("install it with: ")[2] for line in done.stderr.splitlines()]
    assert told == [f"pip install 'swarmgrasp[{extra}]'" for extra in said.values()]
