"""The page's sources: what they work out by themselves, and that the page is made of them."""

import shutil
import subprocess
from pathlib import Path

import pytest

CLIENT = Path(__file__).parents[2] / "src" / "swarmgrasp" / "gui" / "client"


@pytest.fixture(scope="module")
def npm():
    """Run a script of the client; return what it did."""
    node = shutil.which("node")
    if node is None or not (CLIENT / "node_modules").is_dir():
        pytest.skip("there is no Node, or `make page` has not installed what the client needs")

    def run(*arguments):
        command = ["npm", "run", "--silent", *arguments]
        return subprocess.run(command, cwd=CLIENT, capture_output=True, text=True)

    return run


def test_what_the_client_works_out_by_itself(npm):
    """Places, gestures, history, links, frames and asking behave as their tests say."""
    done = npm("test")
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_page_is_what_its_sources_give(npm, tmp_path):
    """The files that are shipped are those that a build gives, byte by byte."""
    assert npm("check").returncode == 0
    done = npm("build", "--", str(tmp_path))
    assert done.returncode == 0, done.stderr
    shipped = CLIENT.parent / "page"
    assert sorted(f.name for f in shipped.iterdir()) == sorted(f.name for f in tmp_path.iterdir())
    built = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    other = [name for name, content in built.items() if (shipped / name).read_bytes() != content]
    assert not other, f"the sources give another {', '.join(other)}; run: make page"


def test_the_lock_names_no_host():
    """The packages that build the page are pinned by what they hold, not by where they are."""
    lock = (CLIENT / "package-lock.json").read_text()
    assert '"integrity"' in lock
    assert '"resolved"' not in lock
