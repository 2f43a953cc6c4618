"""The command `swarmgrasp`, before the package is there."""

import os
import subprocess
import sys


def test_ctrl_c_during_the_imports_is_no_traceback(tmp_path):
    """They take a second on a busy machine; exit status 130, and not a word."""
    package = tmp_path / "swarmgrasp"
    package.mkdir()
    (package / "__init__.py").write_text("raise KeyboardInterrupt")
    done = subprocess.run(
        [sys.executable, "-c", "import swarmgrasp_command; swarmgrasp_command.run()"],
        capture_output=True, text=True, check=False,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")
