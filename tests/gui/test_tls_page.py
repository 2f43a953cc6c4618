"""A page that others may reach: by one name, over TLS, with a certificate made here."""

import datetime
import ipaddress
import signal
import socket
import ssl
import subprocess
import sys
import urllib.error
import urllib.request

import pytest

from swarmgrasp.cli import main

x509 = pytest.importorskip("cryptography.x509")
from cryptography.hazmat.primitives import hashes, serialization  # noqa: E402
from cryptography.hazmat.primitives.asymmetric import ec  # noqa: E402

OTHER = "127.0.0.2"
"""An address of this machine that is not the usual one, and that nobody else reaches."""
PEM = serialization.Encoding.PEM


@pytest.fixture
def tls(tmp_path):
    """Make a certificate of the address, and its key."""
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, OTHER)])
    now = datetime.datetime.now(datetime.UTC)
    made = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(1)
        .not_valid_before(now - datetime.timedelta(days=1))
        .not_valid_after(now + datetime.timedelta(days=1))
        .add_extension(
            x509.SubjectAlternativeName([x509.IPAddress(ipaddress.ip_address(OTHER))]), False
        )
        .add_extension(x509.BasicConstraints(ca=True, path_length=None), critical=True)
        .sign(key, hashes.SHA256())
    )
    (tmp_path / "page.pem").write_bytes(made.public_bytes(PEM))
    private = key.private_bytes(
        PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    (tmp_path / "page.key").write_bytes(private)
    return tmp_path / "page.pem", tmp_path / "page.key"


def is_ours(host):
    """Tell whether an address is one of this machine."""
    with socket.socket() as asked:
        try:
            asked.bind((host, 0))
        except OSError:
            return False
        return True


def test_without_a_certificate_nothing_is_opened(capsys):
    """It says what would be opened, and what to give."""
    assert main(["studio", "rectangle-5", "--host", OTHER]) == 2
    said = capsys.readouterr().err
    assert f"--host {OTHER} opens the page to others, who could read along" in said
    assert "give --certificate and --key" in said


@pytest.mark.skipif(not is_ours(OTHER), reason="this machine has one loopback address")
def test_with_one_the_page_is_served_over_tls_alone(window, tls):
    """The link names the address; the certificate is its own; plain requests get nothing."""
    certificate, key = map(str, tls)
    words = ["studio", "rectangle-5", "--host", OTHER, "--certificate", certificate, "--key", key]
    process = subprocess.Popen(
        [sys.executable, "-m", "swarmgrasp", *words, "--no-browser"],
        stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    with process:
        try:
            link = process.stdout.readline().strip()
            base = link.partition("/#")[0]
            assert base.startswith(f"https://{OTHER}:")
            trusted = ssl.create_default_context(cafile=certificate)
            with urllib.request.urlopen(base, context=trusted) as page:
                assert b"<script" in page.read()
            with pytest.raises((urllib.error.URLError, OSError)):
                urllib.request.urlopen(base.replace("https", "http"), timeout=20)
            asked = urllib.request.Request(base, headers={"Host": "evil.example"})
            with pytest.raises(urllib.error.HTTPError, match="421"):
                urllib.request.urlopen(asked, context=trusted)
            one = window(at=link, ignore_https_errors=True)
            assert one.text(".scene-title") == "Rectangle, 5 robots"
            assert one.text(".first").startswith("Holds ")
        finally:
            process.send_signal(signal.SIGINT)
            assert process.wait(60) == 130
