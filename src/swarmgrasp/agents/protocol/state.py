"""What a robot remembers from one life of its process to the next, as bytes."""

import msgspec

from swarmgrasp.agents.protocol.record import Record, record_fault
from swarmgrasp.errors import AgentInvalid

FORMAT = "swarmgrasp agent 1"


class State(msgspec.Struct, frozen=True):
    """What an agent knows.

    Attributes
    ----------
    clock : int
        Its Lamport time.
    records : tuple of Record
        Its own among them.
    reckoned : tuple of (str, int, int)
        The arrivals of others that it has confirmed.
    """

    clock: int
    records: tuple[Record, ...]
    reckoned: tuple[tuple[str, int, int], ...]


class _Kept(msgspec.Struct, frozen=True):
    format: str
    mission: str
    name: str
    state: State


def state_bytes(state: State, mission: str, name: str) -> bytes:
    """Return a state as bytes, for one robot in one mission.

    Parameters
    ----------
    state : State
    mission, name : str
        The digest of the mission, and the robot's name.
    """
    return msgspec.msgpack.encode(_Kept(FORMAT, mission, name, state))


def read_state(data: bytes, mission: str, name: str) -> State:
    """Return the state that bytes hold.

    Parameters
    ----------
    data : bytes
        As `state_bytes` returns them.
    mission, name : str
        Whose state it should be.

    Raises
    ------
    AgentInvalid
        If they hold none, or that of another robot or another mission.
    """
    try:
        kept = msgspec.msgpack.decode(data, type=_Kept)
    except (msgspec.MsgspecError, ValueError) as error:
        raise AgentInvalid(f"the state is damaged: {error}; remove it to start without") from None
    faults = []
    if kept.format != FORMAT:
        faults.append(f"the state has the format {kept.format!r}; it should be {FORMAT!r}")
    if kept.name != name:
        faults.append(f"the state is that of {kept.name}, not of {name}")
    if kept.mission != mission:
        faults.append(f"the state is of the mission {kept.mission}, not of {mission}")
    faults += [f"the state: {r.id} {f}" for r in kept.state.records if (f := record_fault(r))]
    if faults:
        raise AgentInvalid(faults)
    return kept.state
