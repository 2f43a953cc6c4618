"""A small authority for trials: whose certificate may write which keys.

The certificate's name is the robot's: a router lets each write its own keys and no other, and
everyone read all. Nothing is hidden from those who hold a certificate of the swarm.
"""

import datetime
import os
from collections.abc import Iterable
from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swarmgrasp.agents.network.keys import ROOT, Keys
from swarmgrasp.agents.protocol.record import id_fault
from swarmgrasp.errors import AgentInvalid
from swarmgrasp.files import folder_faults
from swarmgrasp.ranges import shown

if TYPE_CHECKING:
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey
    from cryptography.x509 import Certificate, Name

AUTHORITY = "authority"
ROUTER = "router"
WATCH = "watch"
OPERATOR = "operator"
"""Who are no robots, though they have certificates."""
NOT_ROBOTS = (AUTHORITY, ROUTER, WATCH, OPERATOR)
USUAL_HOSTS = ("localhost", "127.0.0.1", "::1")
YEARS = 2
"""How long certificates hold."""
_WORDS = ("put", "delete", "reply", "declare_queryable", "liveliness_token")
"""Kinds of messages that write."""
_ALL = (
    *_WORDS, "query", "declare_subscriber", "liveliness_query", "declare_liveliness_subscriber",
)  # fmt: skip


@dataclass(frozen=True)
class Papers:
    """What a process shows of itself, and asks of others: files in a folder.

    Attributes
    ----------
    folder : Path
    name : str
    """

    folder: Path
    name: str

    @property
    def certificate(self) -> Path:
        """The file of its certificate."""
        return self.folder / f"{self.name}.pem"

    @property
    def key(self) -> Path:
        """The file of its private key."""
        return self.folder / f"{self.name}.key"

    @property
    def authority(self) -> Path:
        """The file of the certificate that all others are signed with."""
        return self.folder / f"{AUTHORITY}.pem"

    def faults(self) -> list[str]:
        """Return what is missing."""
        missing = [path for path in (self.authority, self.certificate, self.key) if not _is(path)]
        robot = "with a new robot" if self.name in NOT_ROBOTS else self.name
        remedy = f"swarmgrasp agents keys {self.folder} {robot}"
        return [f"{path}: there is no such file, or it may not be read; {remedy} makes it"
                for path in missing]  # fmt: skip

    def zenoh_config(self, *, is_router: bool) -> dict[str, Any]:
        """Return what Zenoh is to be told of them."""
        side = "listen" if is_router else "connect"
        told: dict[str, Any] = {
            "root_ca_certificate": str(self.authority),
            "enable_mtls": True,
            "verify_name_on_connect": True,
            "close_link_on_expiration": True,
        }
        for each in {side, "connect"}:
            told[f"{each}_certificate"] = str(self.certificate)
            told[f"{each}_private_key"] = str(self.key)
        return told

    def access_control(self) -> dict[str, Any]:
        """Return who may write what, for a router."""
        names = sorted(
            path.stem
            for path in self.folder.glob("*.pem")
            if path.stem not in NOT_ROBOTS and not id_fault(path.stem)
        )
        own = [Keys("*", "*", name) for name in names]
        everything = f"{ROOT}/**"
        reading = [each for each in _ALL if each not in _WORDS]
        rules: list[dict[str, Any]] = [
            _rule("read", reading, [everything], "ingress", "egress"),
            _rule("hear", _ALL, [everything], "egress"),
            _rule("pass on", _ALL, [everything], "ingress", "egress"),
            _rule("ask", ["put"], [Keys("*", "*", "*").ask], "ingress"),
        ]
        subjects: list[dict[str, Any]] = [
            {"id": "anyone"},
            {"id": ROUTER, "cert_common_names": [ROUTER]},
            {"id": OPERATOR, "cert_common_names": [OPERATOR]},
        ]
        policies = [
            {"rules": ["read", "hear"], "subjects": ["anyone"]},
            {"rules": ["pass on"], "subjects": [ROUTER]},
            {"rules": ["ask"], "subjects": [OPERATOR]},
        ]
        for name, keys in zip(names, own, strict=True):
            # a robot may be called "read": its rule and its subject have names of their own
            rules.append(_rule(f"be {name}", _WORDS, keys.written, "ingress"))
            subjects.append({"id": f"robot {name}", "cert_common_names": [name]})
            policies.append({"rules": [f"be {name}"], "subjects": [f"robot {name}"]})
        return {
            "enabled": True,
            "default_permission": "deny",
            "rules": rules,
            "subjects": subjects,
            "policies": policies,
        }


def _rule(name: str, messages: Iterable[str], keys: Iterable[str], *flows: str) -> dict[str, Any]:
    """Return a rule that lets messages under some keys pass."""
    return {
        "id": name,
        "permission": "allow",
        "messages": list(messages),
        "flows": list(flows),
        "key_exprs": list(keys),
    }


def make_papers(folder: Path, names: Iterable[str], hosts: Iterable[str] = ()) -> list[Path]:
    """Make certificates for robots; an authority, a router's, a watcher's and an operator's too.

    The latter four are made if there are none.

    Parameters
    ----------
    folder : Path
        Created if need be. Nothing in it is overwritten.
    names : iterable of str
        Robots.
    hosts : iterable of str
        Names or addresses under which the router will be reached, beside this machine's own.

    Returns
    -------
    list of Path
        The files that were written: certificates for everyone to read, private keys for their
        owner alone.

    Raises
    ------
    AgentInvalid
        If a name cannot be one on the network or has a certificate, or the folder cannot be used.
    """
    wanted = list(names)
    faults = folder_faults(folder)
    faults += [f"a robot {fault}" for name in wanted if (fault := id_fault(name))]
    faults += [f"{n} is no robot's name here; choose another" for n in wanted if n in NOT_ROBOTS]
    faults += [f"{name} is given twice" for name in sorted(set(wanted)) if wanted.count(name) > 1]
    faults += [f"the host is {shown(h)}; it should be a name or an address"
               for h in hosts if not h.strip()]  # fmt: skip
    taken = [path for n in wanted for path in (folder / f"{n}.pem", folder / f"{n}.key")
             if os.path.lexists(path)]  # fmt: skip
    faults += [f"{path}: exists already; nothing was overwritten" for path in taken]
    has_authority = _is(folder / f"{AUTHORITY}.pem") and _is(folder / f"{AUTHORITY}.key")
    if has_authority and hosts:
        faults.append("the router has its certificate already; choose its hosts in a new folder")
    if faults:
        raise AgentInvalid(faults)
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    authority = _Authority.read(folder) if has_authority else _Authority.new()
    made = [] if has_authority else authority.write(folder, hosts)
    if not os.path.lexists(folder / f"{OPERATOR}.pem"):  # a folder of before may have none
        made += authority.write_for(folder, OPERATOR)
    for name in wanted:
        made += authority.write_for(folder, name)
    return made


class _Authority:
    """Who signs."""

    def __init__(self, certificate: "Certificate", key: "EllipticCurvePrivateKey") -> None:
        self.certificate, self.key = certificate, key

    @classmethod
    def new(cls) -> "_Authority":
        """Make one."""
        from cryptography.hazmat.primitives.asymmetric import ec

        key = ec.generate_private_key(ec.SECP256R1())
        name = _named(f"swarmgrasp {AUTHORITY}")
        return cls(_signed(name, name, key.public_key(), key), key)

    @classmethod
    def read(cls, folder: Path) -> "_Authority":
        """Read one."""
        from cryptography import x509
        from cryptography.hazmat.primitives.asymmetric import ec
        from cryptography.hazmat.primitives.serialization import load_pem_private_key

        try:
            certificate = x509.load_pem_x509_certificate((folder / f"{AUTHORITY}.pem").read_bytes())
            key = load_pem_private_key((folder / f"{AUTHORITY}.key").read_bytes(), None)
        except (ValueError, TypeError) as error:
            raise AgentInvalid(f"{folder}: its authority cannot be read: {error}") from None
        if not isinstance(key, ec.EllipticCurvePrivateKey):
            raise AgentInvalid(f"{folder}: its authority is none that was made here")
        return cls(certificate, key)

    def write(self, folder: Path, hosts: Iterable[str]) -> list[Path]:
        """Write itself, and what the router and a watcher show."""
        made = _write(folder, AUTHORITY, self.certificate, self.key)
        made += self.write_for(folder, ROUTER, (*USUAL_HOSTS, *hosts))
        return made + self.write_for(folder, WATCH)

    def write_for(self, folder: Path, name: str, hosts: Iterable[str] = ()) -> list[Path]:
        """Write what someone shows; with hosts, others may connect to it."""
        from cryptography.hazmat.primitives.asymmetric import ec

        key = ec.generate_private_key(ec.SECP256R1())
        issuer, hosts = self.certificate.subject, tuple(dict.fromkeys(hosts))
        certificate = _signed(_named(name), issuer, key.public_key(), self.key, hosts)
        return _write(folder, name, certificate, key)


def _named(name: str) -> "Name":
    """Return a certificate's name."""
    from cryptography import x509
    from cryptography.x509.oid import NameOID

    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, name)])


def _signed(
    name: "Name", issuer: "Name", public: Any, key: "EllipticCurvePrivateKey",
    hosts: tuple[str, ...] = (),
) -> "Certificate":  # fmt: skip
    """Return a certificate: one that signs others if it is its own issuer."""
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes
    from cryptography.x509.oid import ExtendedKeyUsageOID

    now = datetime.datetime.now(datetime.UTC)
    is_authority = name == issuer
    builder = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(issuer)
        .public_key(public)
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - datetime.timedelta(hours=1))
        .not_valid_after(now + datetime.timedelta(days=365 * YEARS))
        .add_extension(x509.BasicConstraints(is_authority, 0 if is_authority else None), True)
    )
    if not is_authority:
        usages = [ExtendedKeyUsageOID.CLIENT_AUTH]
        usages += [ExtendedKeyUsageOID.SERVER_AUTH] if hosts else []
        builder = builder.add_extension(x509.ExtendedKeyUsage(usages), False)
    if hosts:
        builder = builder.add_extension(
            x509.SubjectAlternativeName([_host(host) for host in hosts]), False
        )
    return builder.sign(key, hashes.SHA256())


def _host(host: str) -> Any:
    """Return a host as certificates have it."""
    from cryptography import x509

    try:
        return x509.IPAddress(ip_address(host))
    except ValueError:
        return x509.DNSName(host)


def _write(
    folder: Path, name: str, certificate: "Certificate", key: "EllipticCurvePrivateKey"
) -> list[Path]:
    """Write a certificate and its key, never over others; the key for its owner alone."""
    from cryptography.hazmat.primitives import serialization as form

    pem = form.Encoding.PEM
    secret = key.private_bytes(pem, form.PrivateFormat.PKCS8, form.NoEncryption())
    papers = Papers(folder, name)
    for path, content, mode in (
        (papers.key, secret, 0o600),
        (papers.certificate, certificate.public_bytes(pem), 0o644),
    ):
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode)
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
    return [papers.certificate, papers.key]


def _is(path: Path) -> bool:
    """Tell whether a file is there to be read."""
    return path.is_file() and os.access(path, os.R_OK)
