"""Try the packages as somebody does who has just found them: in clean environments.

The wheel goes in where no compiler can be had; the source archive is built, and all its quick tests
run. With the first Python its documents are built too. `make dist` does that with each Python of
the versions below that this machine has, `make packages` tries the wheel with one.
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
THIS = ".".join(map(str, sys.version_info[:2]))
SAID = "import ensurepip, sys; print('.'.join(map(str, sys.version_info[:2])))"
PINNED = (
    "-m",
    "pip",
    "install",
    "--quiet",
    "--disable-pip-version-check",
    "--require-hashes",
    "-r",
)
WRITING = ("--plot", "plan.png", "--json", "answer.json")
OWN = ("-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps")


def pythons() -> dict[str, Path]:
    """Return the Pythons of this machine by version: this one, on the path, or kept by pyenv."""
    kept = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    found = {}
    for version in VERSIONS:
        named = shutil.which(f"python{version}")
        tried = [
            *([Path(sys.executable)] if version == THIS else []),
            *sorted(kept.glob(f"{version}.*/bin/python")),
            *([Path(named)] if named else []),
        ]
        for python in tried:
            said = subprocess.run([python, "-c", SAID], capture_output=True, text=True, check=False)
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


def try_wheel(python: Path, wheel: Path, locked: Path, folder: Path) -> str:
    """Install the wheel where there is no compiler, and have an answer; return the verdict."""
    commands = environment(python, folder / "wheel", locked)
    alone = {"PATH": str(commands)}
    run(commands / "python", *OWN, "--only-binary=:all:", wheel, where=folder, **alone)
    command = commands / "swarmgrasp"
    run(command, "place", "deck-barge", *WRITING, where=folder, **alone)
    return run(command, "verify", "answer.json", where=folder, **alone).splitlines()[0]


def try_source(python: Path, archive: Path, folder: Path, *, documents: bool) -> str:
    """Build and install the source archive, and run its tests; return their last line."""
    with tarfile.open(archive) as packed:
        packed.extractall(folder, filter="data")
    (source,) = folder.glob("swarmgrasp-*")
    lock = "docs" if documents else "dev"
    commands = environment(python, folder / "source", source / f"requirements-{lock}.lock")
    run(commands / "python", *OWN, "--no-build-isolation", ".", where=source)
    if documents:
        run(commands / "sphinx-build", "-q", "-W", "docs", "site", where=source)
        run(commands / "python", "tools/check_site.py", "site", where=source)
    # they see what was installed: nothing leads into `src`, which has no kernels besides
    tests = ("-m", "pytest", "-q", "-n", "2", "--dist", "worksteal", "tests")
    return run(commands / "python", *tests, where=source).splitlines()[-1]


def main() -> None:
    """Try the packages."""
    asked = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    asked.add_argument("folder", type=Path, help="where the packages are")
    asked.add_argument("--wheel", action="store_true", help="the wheel alone, with this Python")
    asked.add_argument("--python", choices=VERSIONS, help="with this version alone")
    options = asked.parse_args()
    (archive,) = options.folder.resolve().glob("*.tar.gz")
    (wheel,) = options.folder.resolve().glob("*.whl")
    locked = Path("requirements.lock").resolve()
    found = pythons()
    wanted = THIS if options.wheel else options.python
    versions = [version for version in found if wanted in (None, version)]
    for version in versions:
        with tempfile.TemporaryDirectory() as made:
            folder, python = Path(made), found[version]
            said = try_wheel(python, wheel, locked, folder)
            print(f"Python {version}, wheel: {said}", flush=True)
            if not options.wheel:
                said = try_source(python, archive, folder, documents=version == versions[0])
                print(f"Python {version}, source: {said}", flush=True)
    missing = [version for version in VERSIONS if version not in found]
    if missing and wanted is None:
        print(f"Not tried, because this machine has no Python {', '.join(missing)}")
    if not versions:
        sys.exit("no Python of these versions was found")


if __name__ == "__main__":
    main()
