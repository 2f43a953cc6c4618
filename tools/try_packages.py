"""Try the packages as somebody does who has just found them: in clean environments.

The wheel goes in where no compiler can be had; the source archive is built, and its own tests run.
Run by `make dist`, with each Python of the versions below that this machine has.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

VERSIONS = ("3.11", "3.12", "3.13", "3.14")
ROOMS = ("tests/kernels", "tests/outline", "tests/swarm", "tests/test_command.py")
"""Tests that run with every Python; the first runs them all if it is asked to."""
PINNED = (
    "-m",
    "pip",
    "install",
    "--quiet",
    "--disable-pip-version-check",
    "--require-hashes",
    "-r",
)
OWN = ("-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps")


def pythons() -> dict[str, Path]:
    """Return the Pythons of this machine by version: on the path, or kept by pyenv."""
    kept = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    found = {}
    for version in VERSIONS:
        named = shutil.which(f"python{version}")
        tried = [*sorted(kept.glob(f"{version}.*/bin/python")), *([Path(named)] if named else [])]
        for python in tried:
            said = subprocess.run(
                [python, "-c", "import ensurepip, sys; print('%d.%d' % sys.version_info[:2])"],
                capture_output=True,
                text=True,
                check=False,
            )
            if said.stdout.strip() == version:
                found[version] = python
                break
    return found


def run(*command: object, where: Path, **environment: str) -> str:
    """Run a command and return what it says; say more and end if it fails."""
    done = subprocess.run(
        [str(part) for part in command],
        cwd=where,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        said = " ".join(map(str, command))
        sys.exit(f"{said} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def environment(python: Path, folder: Path, locked: Path) -> Path:
    """Return the folder of commands of a new environment that has what a lock file lists."""
    run(python, "-m", "venv", folder, where=folder.parent)
    run(folder / "bin/python", *PINNED, locked, where=folder.parent)
    return folder / "bin"


def first_answer(commands: Path, folder: Path) -> str:
    """Have an answer and its proof checked; return the verdict's first line."""
    run(commands / "swarmgrasp", "place", "deck-barge", "--json", "answer.json", where=folder)
    said = run(commands / "swarmgrasp", "verify", "answer.json", where=folder)
    return said.splitlines()[0]


def try_wheel(python: Path, wheel: Path, locked: Path, folder: Path) -> str:
    """Install the wheel where there is no compiler, and have an answer."""
    commands = environment(python, folder / "wheel", locked)
    no_compiler = {"CC": "false", "CXX": "false"}
    run(commands / "python", *OWN, "--only-binary=:all:", wheel, where=folder, **no_compiler)
    return first_answer(commands, folder)


def try_source(python: Path, archive: Path, folder: Path, tests: tuple[str, ...]) -> str:
    """Build and install the source archive, and run its tests; return their last line."""
    with tarfile.open(archive) as packed:
        packed.extractall(folder, filter="data")
    (source,) = folder.glob("swarmgrasp-*")
    commands = environment(python, folder / "source", source / "requirements-dev.lock")
    run(commands / "python", *OWN, "--no-build-isolation", ".", where=source)
    shutil.rmtree(source / "src")  # the tests are to see what was installed, and nothing else
    said = run(
        commands / "python", "-m", "pytest", "-q", "-n", "2", "--dist", "worksteal", *tests,
        where=source,
    )  # fmt: skip
    return said.splitlines()[-1]


def main() -> None:
    """Try both packages with every Python that can be had."""
    asked = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    asked.add_argument("folder", type=Path, help="where the packages are")
    asked.add_argument("--whole", action="store_true", help="all quick tests with the first Python")
    options = asked.parse_args()
    (archive,) = options.folder.resolve().glob("*.tar.gz")
    (wheel,) = options.folder.resolve().glob("*.whl")
    locked = Path("requirements.lock").resolve()
    found = pythons()
    for number, (version, python) in enumerate(found.items()):
        with tempfile.TemporaryDirectory() as made:
            folder = Path(made)
            print(
                f"Python {version}, wheel: {try_wheel(python, wheel, locked, folder)}", flush=True
            )
            tests = () if options.whole and number == 0 else ROOMS
            said = try_source(python, archive, folder, tests)
            print(f"Python {version}, source: {said}", flush=True)
    missing = [version for version in VERSIONS if version not in found]
    if missing:
        print(f"Not tried, because this machine has no Python {', '.join(missing)}")
    if not found:
        sys.exit("no Python of these versions was found")


if __name__ == "__main__":
    main()
