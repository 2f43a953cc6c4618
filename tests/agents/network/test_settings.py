from pathlib import Path

import pytest

from swarmgrasp.agents.network import NetworkSettings
from swarmgrasp.errors import AgentInvalid


def test_only_this_machine_is_listened_to_and_nothing_is_looked_for():
    """Whoever wants more says where."""
    peer, router = NetworkSettings(), NetworkSettings(mode="router")
    client = NetworkSettings(mode="client")
    assert (peer.listen, peer.connect) == (("tcp/127.0.0.1:0",), ())
    assert router.listen == client.connect == ("tcp/127.0.0.1:7447",)
    assert not any(s.zenoh_config()["scouting/multicast/enabled"] for s in (peer, router, client))


@pytest.mark.parametrize(
    ("given", "fault"),
    [
        ({"listen": ("127.0.0.1",)}, "the endpoint is '127.0.0.1'; it should be as tcp/127"),
        ({"connect": ("tcp/host:99999",)}, "the endpoint is 'tcp/host:99999'"),
        ({"connect": ("tls/host:1",)}, "is by tls; without --tls it should be tcp"),
        ({"lease": float("nan")}, "the lease is nan; it should be 0.1 to 3600"),
        ({"mode": "boat"}, "the mode is 'boat'; it should be peer, client or router"),
        ({"mode": "client", "listen": ("tcp/a:1",)}, "a client listens nowhere"),
        ({"tls": Path("nowhere"), "name": "Ajax"}, "with certificates robots are clients"),
        (
            {"tls": Path("nowhere"), "name": "Ajax", "mode": "client"},
            "nowhere/Ajax.key: there is no such file, or it may not be read; "
            "swarmgrasp agents keys nowhere Ajax makes it",
        ),
    ],
)
def test_what_cannot_be_is_told(given, fault):
    """Each with the value, what it should be, or what to do."""
    with pytest.raises(AgentInvalid) as error:
        NetworkSettings(**given)
    assert any(fault in each for each in error.value.faults)
