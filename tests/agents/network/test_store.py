import errno
import os

import pytest

from swarmgrasp.agents.network import Store, incarnation_of
from swarmgrasp.agents.protocol import Phase, Record, State
from swarmgrasp.agents.protocol.record import LIVES
from swarmgrasp.errors import AgentInvalid


def state(sequence=1, lives=1):
    """Return what a robot might know."""
    return State(7, (Record("Ajax", lives * LIVES + 5, sequence, Phase.LEFT),), ())


def full(*_, **__):
    """Do as a full disk does."""
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_a_state_outlives_its_process(tmp_path):
    """What was kept is read again; its robot's next start has the next number."""
    path = tmp_path / "Ajax.state"
    assert Store(path, "m", "Ajax").read() is None
    assert Store(path, "m", "Ajax").write(state()) == ""
    known = Store(path, "m", "Ajax").read()
    assert known == state()
    assert incarnation_of(known, "Ajax") // LIVES == 2
    assert incarnation_of(None, "Ajax") // LIVES == 1
    assert len({incarnation_of(None, "Ajax") for _ in range(20)}) > 10
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    ("mission", "name", "fault"),
    [("n", "Ajax", "the state is of the mission m, not of n"),
     ("m", "Dione", "the state is that of Ajax, not of Dione")],
)  # fmt: skip
def test_another_s_state_is_refused(tmp_path, mission, name, fault):
    """Of another mission or another robot, with the file's name."""
    path = tmp_path / "a.state"
    Store(path, "m", "Ajax").write(state())
    with pytest.raises(AgentInvalid, match=fault):
        Store(path, mission, name).read()
    path.write_bytes(b"\x93\x01")
    with pytest.raises(AgentInvalid, match=r"a\.state: the state is damaged"):
        Store(path, mission, name).read()


def test_a_full_disk_leaves_no_old_state_behind(tmp_path, monkeypatch):
    """It is told once, the robot goes on, and its next life knows that it knows nothing."""
    store = Store(tmp_path / "Ajax.state", "m", "Ajax")
    store.write(state(1))
    with monkeypatch.context() as disk:
        disk.setattr(os, "fsync", full)
        assert "cannot keep its state" in store.write(state(2))
        assert store.write(state(3)) == ""
        assert list(tmp_path.iterdir()) == []
    assert store.read() is None
    assert "again" in store.write(state(3))
    assert store.read() == state(3)


def test_if_the_old_state_cannot_be_removed_the_process_ends(tmp_path, monkeypatch):
    """What the next life would believe is no longer so: nothing more is promised."""
    store = Store(tmp_path / "Ajax.state", "m", "Ajax")
    store.write(state(1))
    monkeypatch.setattr(os, "fsync", full)
    monkeypatch.setattr(type(store.path), "unlink", full)
    with pytest.raises(AgentInvalid, match="this process ends"):
        store.write(state(2))
