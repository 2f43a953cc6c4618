"""The server as a stranger meets it: what it refuses, and that it then still answers."""

import gzip
import http.client
import json
import logging
from collections.abc import Iterator
from contextlib import suppress

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from paged import Window, address, served
from swarmgrasp.gui.guard import BURST, MOST_BYTES, POLICY, WRONG_KEY
from swarmgrasp.gui.server import Opened


@pytest.fixture(scope="module")
def serving() -> Iterator[Opened]:
    with served() as found:
        yield found


def get(serving: Opened, path: str = "/", **headers: str) -> tuple[int, dict[str, str], bytes]:
    """Fetch a path with some headers."""
    host = address(serving).removeprefix("http://")
    asking = http.client.HTTPConnection(host, timeout=30)
    asking.request("GET", path, headers={"Host": host, **headers})
    answer = asking.getresponse()
    found = answer.status, dict(answer.getheaders()), answer.read()
    asking.close()
    return found


def test_files_of_the_page_come_with_a_strict_policy(serving: Opened) -> None:
    """No program but its own, nothing from elsewhere, no frame around it."""
    status, headers, body = get(serving)
    assert (status, headers["content-security-policy"]) == (200, POLICY)
    assert headers["x-content-type-options"] == "nosniff"
    assert b"<script" in body
    assert "server" not in {name.lower() for name in headers}


def test_files_are_packed_for_those_that_can_unpack_them(serving: Opened) -> None:
    """The same bytes either way."""
    plain = get(serving, "/main.js")
    packed = get(serving, "/main.js", **{"Accept-Encoding": "br, gzip"})
    assert gzip.decompress(packed[2]) == plain[2]
    assert packed[1]["content-encoding"] == "gzip"
    assert len(packed[2]) < 0.5 * len(plain[2])


@pytest.mark.parametrize("path", ["/../pyproject.toml", "/%2e%2e/guard.py", "/etc/passwd", "/x"])
def test_no_other_file_is_sent(serving: Opened, path: str) -> None:
    """Names are looked up in a fixed list."""
    assert get(serving, path)[0] == 404


def test_a_foreign_host_is_refused(serving: Opened) -> None:
    """So a name that is bound anew to this machine gets nothing."""
    assert get(serving, Host="evil.example")[0] == 421
    assert get(serving, Host="127.0.0.1:1")[0] == 421


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_a_page_of_another_site_is_refused(serving: Opened, site: str) -> None:
    """Its own page, and an address that is typed, are not."""
    assert get(serving, **{"Sec-Fetch-Site": site})[0] == 403
    assert get(serving, **{"Sec-Fetch-Site": "none"})[0] == 200
    assert get(serving, **{"Sec-Fetch-Site": "same-origin"})[0] == 200


@pytest.mark.parametrize("origin", [None, "null", "http://evil.example", "https://127.0.0.1"])
def test_a_socket_of_another_origin_is_refused(serving: Opened, origin: str | None) -> None:
    """A missing origin, too."""
    with pytest.raises(InvalidStatus) as refusal:
        Window(serving, origin=origin)
    assert refusal.value.response.status_code == 403


def test_a_wrong_key_ends_the_window(serving: Opened) -> None:
    """So does anything else than a key."""
    for first in (
        {"kind": "hello", "key": "0" * 32, "protocol": 1},
        {"kind": "open", "n": 1, "name": "escort-ring"},
        {"kind": "hello", "key": "\u00e4", "protocol": 1},
    ):
        with Window(serving) as window:
            window.say(**first)
            with pytest.raises(ConnectionClosed) as closed:
                window.told()
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == WRONG_KEY


def test_another_protocol_is_told(serving: Opened) -> None:
    """An old page is to be loaded anew."""
    with Window(serving) as window, pytest.raises(ConnectionClosed, match="another version"):
        window.hello(protocol=0)


def test_hostile_messages_get_a_word_and_the_window_lives(serving: Opened) -> None:
    """Whatever is said, the next question is answered as before."""
    with Window(serving) as window:
        assert window.hello()["kind"] == "welcome"
        scene = window.scene("rectangle-5")
        before = window.ask(scene)["answer"]["after"]
        for raw in ('{"kind":"ask"}', b"\x00\xff", "[" * 50_000, '{"kind":"open","n":1}'):
            window.socket.send(raw)
            assert window.told()["kind"] == "error"
        assert window.scene("../../etc/passwd")["kind"] == "error"
        for change in (
            {"spacing": -1.0},
            {"spacing": 1e308},
            {"zones": 7},
            {"more": 1},
            {"criterion": {**scene["doc"]["problem"]["criterion"], "losing": -3}},
            {"criterion": {**scene["doc"]["problem"]["criterion"], "losing": 10**12}},
        ):
            doc = {**scene["doc"], "problem": {**scene["doc"]["problem"], **change}}
            (told,) = window.ask({**scene, "doc": doc}).values()
            assert told["kind"] == "refused"
            assert all(fault["sentence"] for fault in told["faults"])
        assert window.ask(scene)["answer"]["after"] == before


def test_what_nobody_here_answers_is_said_so(serving: Opened) -> None:
    """A run where none is played, and a sheet where none is made: the page waits for neither."""
    with Window(serving) as window:
        welcome = window.hello()
        assert (welcome["run"], welcome["reports"]) == (None, False)
        assert window.request(kind="run", name="run")["say"] == "This cannot be asked here."


def test_robots_of_one_name_are_refused(serving: Opened) -> None:
    """The fault says which."""
    with Window(serving) as window:
        window.hello()
        scene = window.scene("deck-barge")
        robots = scene["doc"]["problem"]["swarm"]["robots"]
        robots[1]["name"] = robots[0]["name"]
        (told,) = window.ask(scene).values()
        assert told["kind"] == "refused"
        assert robots[0]["name"] in told["faults"][0]["sentence"]


def test_a_message_that_is_too_large_ends_the_window(serving: Opened) -> None:
    """The page knows the limit from its welcome, and says it itself; one just below is read."""
    with Window(serving) as window:
        assert window.hello()["limits"]["message"] == MOST_BYTES
        window.socket.send("a" * MOST_BYTES)
        assert window.told()["kind"] == "error"
        with suppress(ConnectionClosed):  # it may end while this is being sent
            window.socket.send("a" * (MOST_BYTES + 1))
        with pytest.raises(ConnectionClosed):
            window.told()


def test_bytes_that_are_no_text_end_the_window_without_a_trace(
    serving: Opened, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the log stands what was wrong, not where in the program it was found."""
    log = logging.getLogger("uvicorn.error")
    monkeypatch.setattr(log, "handlers", [*log.handlers, caplog.handler])
    with Window(serving) as window:
        window.hello()
        window.socket.send(b"\xff", text=True)
        with pytest.raises(ConnectionClosed):
            window.told()
    assert {record.exc_info for record in caplog.records} == {None}


def test_a_flood_is_dropped_with_a_word(serving: Opened) -> None:
    """Then the window goes on."""
    with Window(serving) as window:
        window.hello()
        many = int(3 * BURST)
        for _ in range(many):
            window.socket.send('{"kind":"cancel","n":1}')
        window.socket.send("!")  # an error in any case: a word for the flood, or for this
        assert window.told()["kind"] == "error"


def test_text_with_faults_tells_line_and_column(serving: Opened) -> None:
    """All of them, each with its key."""
    with Window(serving) as window:
        window.hello()
        told = window.request(kind="text", name="mine", text="robots: [{at: 4.5, limit: -2}]\n")
        assert told["kind"] == "faults"
        assert {fault["path"] for fault in told["faults"]} >= {"outline", "robots.0.limit"}
        assert all(fault["line"] == 1 and fault["column"] for fault in told["faults"])


def test_a_text_takes_nothing_from_files(serving: Opened) -> None:
    """No path that a page names is opened."""
    with Window(serving) as window:
        window.hello()
        text = "outline: {file: /etc/passwd}\nrobots: []\n"
        told = window.request(kind="text", name="mine", text=text)
        assert told["kind"] == "faults"
        assert "root:" not in json.dumps(told)


def test_a_window_that_comes_again_finds_all_as_it_was(serving: Opened) -> None:
    """The server keeps nothing of a document: another window asks on with it."""
    with Window(serving) as first:
        first.hello()
        scene = first.scene("rectangle-5")
        before = first.ask(scene)["answer"]
    with Window(serving) as second:
        second.hello()
        after = second.ask(scene)["answer"]
        assert {k: v for k, v in after.items() if k != "ms"} == {
            k: v for k, v in before.items() if k not in ("ms", "n")
        } | {"n": after["n"]}
