"""`swarmgrasp studio`: what it refuses before a page opens, and how it starts and ends."""

import signal
import subprocess
import sys
import urllib.request

from swarmgrasp.cli import main
from swarmgrasp.scenario import example_text


def complaint(capsys, *words):
    assert main(["studio", *words]) == 2
    return capsys.readouterr().err


def test_faults_are_told_at_once_and_no_page_opens(capsys):
    """Port, address, file and run."""
    said = complaint(
        capsys, "nothing.yaml", "--port", "70000", "--host", "192.0.2.1", "--run", "no.json"
    )
    for fault in ("--port is 70000", "--host 192.0.2.1 opens", "nothing.yaml", "no.json"):
        assert fault in said


def test_it_opens_to_others_by_one_name_and_with_tls_only(capsys, tmp_path):
    """Not at all addresses, not without a certificate and its key."""
    assert "one address" in complaint(capsys, "--host", "0.0.0.0")
    assert "go together" in complaint(capsys, "--certificate", "a.pem")
    (tmp_path / "a.pem").write_text("none")
    path = str(tmp_path / "a.pem")
    said = complaint(capsys, "--host", "192.0.2.1", "--certificate", path, "--key", path)
    assert "cannot be used" in said


def test_it_prints_its_link_serves_and_ends_with_ctrl_c():
    """A scenario that another command prints is taken from standard input."""
    process = subprocess.Popen(
        [sys.executable, "-m", "swarmgrasp", "studio", "-", "--no-browser"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    with process:
        process.stdin.write(example_text("rectangle-5"))
        process.stdin.close()
        base, _, key = process.stdout.readline().strip().partition("/#k=")
        with urllib.request.urlopen(base) as page:
            assert b"<script" in page.read()
        assert len(key) == 32
        process.send_signal(signal.SIGINT)
        assert process.wait(60) == 130
        assert process.stdout.read() == ""
