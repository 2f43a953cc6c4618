"""Certificates, and what a router lets those who show them write: tried from outside."""

import json
from queue import SimpleQueue

import pytest
from mcap.reader import make_reader

from on_the_wire import BLOCK, await_listener
from swarmgrasp.agents.network import NetworkSettings, Router, make_papers
from swarmgrasp.agents.network import settings as settings_module
from swarmgrasp.agents.network.fleet import free_ports
from swarmgrasp.agents.network.keys import Keys
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.errors import AgentInvalid, NetworkFailed

AJAX, BOREAS = Keys("1", "m", "Ajax"), Keys("1", "m", "Boreas")


@pytest.fixture
def papers(tmp_path):
    """Certificates for two robots."""
    make_papers(tmp_path / "papers", ["Ajax", "Boreas"])
    return tmp_path / "papers"


@pytest.fixture
def gate(fleet, papers):
    """Run a router that asks for certificates, and give a way in."""
    end = f"tls/127.0.0.1:{free_ports(1)[0]}"
    router = fleet.start("router", "--listen", end, "--tls", papers)
    fleet.wait(lambda: bool(router.told), "a router")
    sessions = []

    def enter(name, folder=papers):
        settings = NetworkSettings(mode="client", connect=(end,), tls=folder, name=name)
        sessions.append(open_session(settings))
        return sessions[-1]

    yield enter
    for session in sessions:
        session.close()


def test_certificates_are_made_once_and_keys_are_for_their_owner_alone(papers):
    """An authority, a router's, a watcher's, an operator's, the robots'; more may be added."""
    names = {"Ajax", "Boreas", "authority", "router", "watch", "operator"}
    files = {f"{name}.{kind}" for name in names for kind in ("pem", "key")}
    assert {path.name for path in papers.iterdir()} == files
    assert all(path.stat().st_mode & 0o777 == 0o600 for path in papers.glob("*.key"))
    before = {path: path.read_bytes() for path in papers.iterdir()}
    assert [path.name for path in make_papers(papers, ["Castor"])] == ["Castor.pem", "Castor.key"]
    assert all(path.read_bytes() == content for path, content in before.items())
    (papers / "operator.pem").unlink()
    (papers / "operator.key").unlink()
    made = [path.name for path in make_papers(papers, ["Dione"])]
    assert made == ["operator.pem", "operator.key", "Dione.pem", "Dione.key"]


@pytest.mark.parametrize(
    ("names", "fault"),
    [
        (["Ajax"], "Ajax.pem: exists already; nothing was overwritten"),
        (["router"], "router is no robot's name here; choose another"),
        (["a/b"], "a name on the network holds none of"),
        (["Dione", "Dione"], "Dione is given twice"),
    ],
)
def test_what_cannot_be_made_is_told_and_nothing_is_written(papers, names, fault):
    """All faults at once, before anything is written."""
    before = set(papers.iterdir())
    with pytest.raises(AgentInvalid) as error:
        make_papers(papers, names)
    assert any(fault in each for each in error.value.faults)
    assert set(papers.iterdir()) == before


def test_a_robot_writes_its_own_keys_and_no_other_s(gate):
    """With Boreas's certificate, nothing of Ajax's gets through: messages, tokens, answers."""
    watcher, boreas, heard = gate("watch"), gate("Boreas"), SimpleQueue()
    everything = "swarmgrasp/**"
    watcher.declare_subscriber(everything, lambda s: heard.put(str(s.key_expr)))
    watcher.liveliness().declare_subscriber(everything, lambda s: heard.put(str(s.key_expr)))
    await_listener(boreas, BOREAS.to_all)
    tokens, queries = [], []
    for keys in (AJAX, BOREAS):  # his own last: what came before has then been refused
        for key in (keys.to_all, keys.to("Castor"), keys.event, keys.order, keys.answer, keys.ask):
            boreas.put(key, b"x", congestion_control=BLOCK)
        queries.append(boreas.declare_queryable(keys.records, lambda q: q.reply(q.key_expr, b"x")))
        tokens.append(boreas.liveliness().declare_token(keys.alive))
    boreas.put(BOREAS.to_all, b"last", congestion_control=BLOCK)
    own = {BOREAS.to_all, BOREAS.to("Castor"), BOREAS.event, BOREAS.order, BOREAS.alive,
           BOREAS.answer}  # fmt: skip
    got = set()
    while not own <= got:
        got.add(heard.get(timeout=60.0))
    assert own == {key for key in got if "/router/" not in key}
    replies = watcher.get("swarmgrasp/1/m/records/*", timeout=1.0)
    assert {str(r.ok.key_expr) for r in replies if r.ok} <= {BOREAS.records}


def test_an_operator_asks_and_does_nothing_else(gate):
    """With the operator's certificate nobody speaks as a robot; who watches may not ask."""
    listener, operator, watcher, heard = (
        gate("Ajax"),
        gate("operator"),
        gate("watch"),
        SimpleQueue(),
    )
    listener.declare_subscriber("swarmgrasp/**", lambda s: heard.put((str(s.key_expr), s.payload)))
    await_listener(operator, AJAX.ask)
    for key in (AJAX.to_all, AJAX.to("Boreas"), AJAX.event, AJAX.order, AJAX.answer):
        operator.put(key, b"x")
    watcher.put(AJAX.ask, b"watch")
    watcher.get("swarmgrasp/1/m/records/*", lambda _: None, timeout=0.1)
    operator.put(AJAX.ask, b"operator", congestion_control=BLOCK)
    key, payload = heard.get(timeout=60.0)
    assert (key, payload.to_bytes()) == (AJAX.ask, b"operator")


def test_another_swarm_s_certificate_and_none_are_refused(gate, tmp_path, monkeypatch):
    """Each is told so in words."""
    monkeypatch.setattr(settings_module, "PATIENCE", 1.0)
    make_papers(tmp_path / "others", ["Ajax"])
    with pytest.raises(NetworkFailed, match="or it refuses this certificate"):
        gate("Ajax", tmp_path / "others")


def test_a_robot_cannot_pass_for_a_router(papers, monkeypatch):
    """Its certificate is not for that: others do not connect to it."""
    monkeypatch.setattr(settings_module, "PATIENCE", 1.0)
    end = f"tls/127.0.0.1:{free_ports(1)[0]}"
    false = Router(NetworkSettings(mode="router", listen=(end,), tls=papers, name="Boreas"))
    with pytest.raises(NetworkFailed, match="or it refuses this certificate"):
        open_session(NetworkSettings(mode="client", connect=(end,), tls=papers, name="Ajax"))
    false.stop()
    false.run()


def test_keys_on_the_command_line(run, tmp_path):
    """It says what it wrote, and what it did not."""
    folder = tmp_path / "keys"
    status, said, _ = run("agents", "keys", folder, "Ajax")
    assert status == 0
    assert f"wrote {folder / 'Ajax.key'}" in said
    status, _, complaint = run("agents", "keys", folder, "Ajax")
    assert (status, "nothing was overwritten" in complaint) == (2, True)


def test_robots_with_certificates_attach_and_are_watched(fleet, papers, run, tmp_path):
    """The whole way: a router, two robots, a watcher that records, over mutual TLS."""
    end = f"tls/127.0.0.1:{free_ports(1)[0]}"
    fleet.start("router", "--listen", end, "--tls", papers)
    for name in ("Ajax", "Boreas"):
        fleet.start(
            name, "--connect", end, "--tls", papers, "--speed", "40 m/s", file="harbour-tugs"
        )
    members = [fleet.members[name] for name in ("Ajax", "Boreas")]
    fleet.wait(lambda: all(m.heard for m in members), "that they hear each other")
    status, said, _ = run("agents", "watch", "harbour-tugs", "--connect", end, "--tls", papers,
                          "--seconds", 3, "--json", "--mcap", tmp_path / "a.mcap")  # fmt: skip
    last = json.loads(said.splitlines()[-1])
    assert status == 0
    assert [(r["name"], r["phase"], r["running"]) for r in last["robots"]] == [
        ("Ajax", "attached", True), ("Boreas", "attached", True),
    ]  # fmt: skip
    assert last["alone"] == ["Castor", "Dione"]
    with (tmp_path / "a.mcap").open("rb") as file:
        recorded = [json.loads(message.data) for *_, message in make_reader(file).iter_messages()]
    assert recorded == [json.loads(line) for line in said.splitlines()]
    status, said, _ = run("agents", "ask", "Ajax", "move", "--connect", end, "--tls", papers)
    assert (status, said.splitlines()[0]) == (0, "Ajax is asked to move: it is asking")
