"""A recorded run and live robots in the page: the line is tapped, and says what a server would."""

import json
import math

import pytest

expect = pytest.importorskip("playwright.sync_api").expect

TIMES = [0.0, 100.0, 200.0, 300.0, 400.0]
PUSHERS = [
    ("Ajax", [-23.4, -10.97], math.pi / 2, 6e5, [[0.0, 400.0]]),
    ("Castor", [-37.1, 1.8], 0.0, 8e5, [[0.0, 100.0]]),
    ("Gaia", [10.0, 10.97], -math.pi / 2, 6e5, [[300.0, 400.0]]),
]
RUN = {
    "kind": "run", "name": "run", "seed": 0, "second": "off by 30 m at most", "within": 5.0,
    "first": {"text": "Not held", "good": False}, "turn": 0.1,
    "outline": [[-37.1, -10.97], [27, -10.97], [37.1, -5], [37.1, 5], [27, 10.97], [-37.1, 10.97]],
    "robots": [
        {"name": n, "contact": c, "direction": d, "limit": f, "there": t, "newcomer": n == "Gaia"}
        for n, c, d, f, t in PUSHERS
    ],
    "routes": [
        {"robot": "Gaia", "start": 100.0, "arrival": 200.0, "joined": 300.0,
         "points": [[60.0, 60.0], [10.0, 10.97]]}
    ],
    "happenings": [
        {"time": 0.0, "kind": "start", "robot": "", "words": "the run begins"},
        {"time": 100.0, "kind": "lost", "robot": "Castor", "words": "Castor is lost"},
    ],
    "times": TIMES, "poses": [0, 0, 0, 0, 0, 0, 30, 0, 0.2, 10, 0, 0.1, 0, 0, 0],
    "references": [0] * 15, "wind": [-5, 9] * 5, "water": [0, 0] * 5,
    "shortfalls": [0, 0, 4e5, 0, 0], "forces": [3e5, 2e5, 0] + [3e5, 0, 0] * 2 + [3e5, 0, 3e5] * 2,
    "angles": [d for _ in TIMES for _, _, d, _, _ in PUSHERS],
}  # fmt: skip


def agent(name, phase, there, **more):
    """Return a live robot as the server tells of it."""
    known = {"Ajax": ([-23.4, -10.9728], math.pi / 2), "Boreas": ([17.7, 10.9728], -math.pi / 2)}
    at, direction = known.get(name, ([5.0, 10.9728], -math.pi / 2))
    told = {
        "name": name, "phase": phase, "at": at, "direction": direction, "limit": 6e5,
        "confirmed": 0, "of": 2, "hears": 2, "deaf": [], "there": there, "process": "runs",
    }  # fmt: skip
    return told | more


def live(robots, whole=True, sides=(), cut=False):
    """Return a message of live robots."""
    first = {"text": "Holds 20 t every way", "good": True}
    return {
        "kind": "live", "t": 0.0, "whole": whole, "first": first, "second": "two hold",
        "certified": 2e5, "robots": robots, "sides": list(sides), "conflicts": [], "cut": cut,
    }  # fmt: skip


@pytest.fixture
def tapped(window):
    """Open a window whose line says more; give it, what it sent, and a voice on its line."""

    def one(welcome, replies):
        sent, voice = [], []

        def tap(line):
            server = line.connect_to_server()

            def up(frame):
                message = json.loads(frame) if isinstance(frame, str) else {}
                sent.append(message)
                reply = replies.get(message.get("kind"))
                if reply is None:
                    server.send(frame)
                else:
                    line.send(json.dumps(reply | ({"n": message["n"]} if reply is RUN else {})))

            def down(frame):
                if isinstance(frame, str) and '"kind":"welcome"' in frame:
                    frame = json.dumps(json.loads(frame) | {"opens": "deck-barge"} | welcome)
                line.send(frame)

            voice.append(lambda message: line.send(json.dumps(message)))
            line.on_message(up)
            server.on_message(down)

        return window(lambda page: page.route_web_socket("**/ws", tap)), sent, voice[0]

    return one


def told(rows):
    """Return what those who hear the page hear of some rows."""
    return rows.evaluate_all("all => all.map(one => one.ariaLabel)")


def test_a_run_is_scrubbed_and_left(tapped):
    """By the bar, by keys and by its events; who is lost or comes is told; the plan comes back."""
    one, _, _ = tapped({"run": "run"}, {"run": RUN})
    bar = one.page.locator(".track")
    assert bar.get_attribute("aria-valuetext").startswith("0:00 of 6:40: 0.0")
    rows = one.page.locator(".of-time .bar-row")
    assert told(rows) == ["Ajax: 50\u00a0%", "Castor: 25\u00a0%"]
    one.click(".event:has-text('Castor is lost')")
    assert bar.get_attribute("aria-valuenow") == "100"
    assert told(rows)[1:] == ["Castor: failed", "Gaia: coming"]
    assert one.page.locator(".missing").is_hidden()
    one.focus(".track")
    one.press(*4 * ["Shift+ArrowRight"])
    assert "making fast" in rows.last.inner_text()
    box = bar.bounding_box()
    one.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 20)
    one.rest()
    assert bar.get_attribute("aria-valuenow") == "200"
    assert one.text(".missing").startswith("41")
    assert one.page.locator(".figure .after[data-bad]").count() == 2
    one.press("End")
    assert bar.get_attribute("aria-valuenow") == "400"
    one.click("button[aria-label='Leave the run']")
    assert one.page.locator(".plan-svg").is_visible()
    assert one.page.locator(".sea").is_hidden()
    one.click(".again")
    assert one.page.locator(".sea").is_visible()


def test_live_robots_are_watched_and_a_copy_edited(tapped):
    """Who holds stands in the plan; who is not heard and who is cut off is told in words."""
    robots = [agent("Ajax", "holds", True), agent("Boreas", "holds", True)]
    robots.append(agent("Gaia", "arrived", False, confirmed=1))
    watching = {"watch": True, "demonstration": True}
    one, sent, say = tapped(watching, {"watch": live(robots), "control": live([], whole=False)})
    expect(one.page.locator(".agent-name").last).to_have_text("Gaia 1 of 2")
    drawn = (
        one.rest().page.locator(".robot").evaluate_all("all => all.map(one => one.dataset.robot)")
    )
    assert drawn == ["Ajax", "Boreas"]
    hung = agent("Boreas", "not answering", True, process="ended")
    say(live([hung], False, [["Ajax", "Gaia"], ["Boreas"]]))
    expect(one.page.locator(".cut")).to_contain_text("Out of touch: Ajax, Gaia | Boreas.")
    assert one.page.locator(".agent-row[data-phase='not answering']").count() == 1
    one.click("button[aria-label='kill Ajax']")
    assert one.page.locator("button:text-is('start again')").get_attribute("aria-label") == (
        "start again Boreas"
    )
    one.click("button:text-is('Cut the network in two')")
    say(live([], False, cut=True))
    one.click("button:text-is('Join the network again')")
    controls = [(m["robot"], m["what"]) for m in sent if m.get("kind") == "control"]
    assert controls == [("Ajax", "kill"), (None, "split"), (None, "join")]
    one.click("button:text-is('Edit a copy')")
    assert sent[-1]["kind"] == "watch"
    assert not sent[-1]["on"]
    assert one.page.locator(".answer:not(.of-time)").is_visible()
