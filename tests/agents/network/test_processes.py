"""Real processes on this machine: killed, stopped, started again with and without memory."""

import json
import math
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from swarmgrasp.agents.network.demo import Demo
from swarmgrasp.agents.network.fleet import ask, free_ports
from swarmgrasp.agents.network.plain import place_data
from swarmgrasp.agents.protocol import Phase, Place, ProblemPlanner, Record, Row
from swarmgrasp.cli import main
from swarmgrasp.scenario import load_example, load_scenario

FILE = "deck-barge"
SPACING = 7.62
RAFT = Path(__file__).parents[3] / "benchmarks" / "raft.yaml"


class Trial:
    """Robots behind one router, and what may be waited for."""

    def __init__(self, fleet, folder, *, lease=2.0, silent=3.5, file=FILE):
        [port] = free_ports(1)
        self.file = file
        self.fleet, self.folder, self.end = fleet, folder, f"tcp/127.0.0.1:{port}"
        self.options = ("--lease", lease, "--silent", silent, "--worth", 0, "--speed", "40 m/s",
                        "--fastening", 0.2)  # fmt: skip
        router = fleet.start("router", "--listen", self.end, "--lease", lease)
        fleet.wait(lambda: bool(router.told), "a router")

    def start(self, name, *options, state=True):
        """Start a robot's process."""
        kept = ("--state", self.folder / f"{name}.state") if state else ()
        return self.fleet.start(name, "--mode", "client", "--connect", self.end, *self.options,
                                *kept, *options, file=str(self.file))  # fmt: skip

    @property
    def robots(self):
        """Return all robots' processes."""
        return [m for m in self.fleet.members.values() if m.name != "router"]

    def running(self):
        """Return those that have not been killed."""
        return [m for m in self.robots if m.process.is_alive()]

    def attached(self, *names):
        """Wait until robots are attached and all that run know it."""

        def is_known():
            records = {name: self.fleet.members[name].record for name in names}
            return all(r.get("phase") == "attached" for r in records.values()) and all(
                robot.heard.get(name) == record
                for robot in self.running()
                for name, record in records.items()
                if name != robot.name
            )

        self.fleet.wait(is_known, f"that {names} are attached")

    def seen_ended(self, name, when):
        """Wait until all that run have seen that a process ended."""
        others = [m for m in self.running() if m.name != name]
        self.fleet.wait(
            lambda: all(
                any(e.get("down") == name and e["clock"] > when for e in m.told) for m in others
            ),
            f"that {name} is seen to have ended",
        )

    def check(self, planner, spacing=SPACING):
        """Check the logs: no word goes back, nobody is too close, all know all, all as central."""
        for robot in self.robots:
            versions = {}
            for told in robot.told:
                if "begins" in told:
                    versions = {}  # a new life may know less
                record = told.get("record") or told.get("heard")
                if record is not None:
                    version = record["incarnation"], record["sequence"]
                    assert version > versions.get(record["name"], (0, -1))
                    versions[record["name"]] = version
        records = {m.name: m.record for m in self.robots}
        for robot in self.running():
            assert {n: r for n, r in records.items() if n != robot.name} == {
                n: r for n, r in robot.heard.items() if n in records
            }
        places = [r["place"] for r in records.values()]
        assert all(
            math.dist((a["x"], a["y"]), (b["x"], b["y"])) >= spacing - 1e-6
            for k, a in enumerate(places)
            for b in places[:k]
        )
        assert places_of(records) == central(planner, records)


def places_of(records):
    """Return the places of newcomers in the order of their tickets."""
    newcomers = [r for r in records.values() if r["ticket"]]
    ordered = sorted(newcomers, key=lambda r: (r["ticket"], r["name"]))
    return [(r["name"], r["place"]) for r in ordered]


def central(planner, records):
    """Return where one computer would put them, one after the other."""
    rows, places = list(planner.present), []
    for name, _ in places_of(records):
        record = Record(name, 1, 0, Phase.LEFT)
        place = planner.place(tuple(rows), (), planner.who(record))
        rows.append(Row(name, records[name]["ticket"], Place(place.x, place.y, place.direction)))
        places.append((name, place_data(place)))
    return places


def test_six_processes_through_kills_hangs_and_restarts(fleet, tmp_path):
    """Killed and stopped ones count as what they were; with and without memory they come back."""
    trial = Trial(fleet, tmp_path)
    planner = ProblemPlanner(load_example(FILE).problem())
    for name in ("Ajax", "Fortuna", "Galatea", "Hector"):
        trial.start(name)
    trial.attached("Ajax", "Fortuna", "Galatea", "Hector")
    when = fleet.kill("Galatea")
    trial.seen_ended("Galatea", when)
    when = fleet.signal("Hector", signal.SIGSTOP)
    trial.seen_ended("Hector", when)
    trial.start("Iris")  # it comes while one is dead and one hangs
    fleet.wait(lambda: fleet.members["Iris"].phase == "attached", "that Iris is attached")
    fleet.signal("Hector", signal.SIGCONT)
    trial.start("Galatea")  # it remembers
    trial.attached("Ajax", "Fortuna", "Galatea", "Hector", "Iris")
    place = fleet.members["Fortuna"].record["place"]
    fleet.kill("Fortuna")
    at = [f"{place['x']} m", f"{place['y']} m", f"{place['direction']} rad"]
    trial.start("Jason")
    trial.attached("Ajax", "Galatea", "Hector", "Iris", "Jason")
    trial.check(planner)
    (tmp_path / "Fortuna.state").unlink()
    trial.start("Fortuna", "--attached-at", *at)  # it remembers nothing, and sees where it is
    trial.attached("Ajax", "Fortuna", "Galatea", "Hector", "Iris", "Jason")
    assert fleet.members["Fortuna"].record["place"] == place
    assert not any(m.reports("too close") for m in trial.robots)


def test_peers_need_no_router(fleet):
    """Each to each: the third learns of the second from the first."""
    end = f"tcp/127.0.0.1:{free_ports(1)[0]}"
    names = ("Fortuna", "Galatea", "Hector")
    for k, name in enumerate(names):
        fleet.start(
            name, "--listen" if k == 0 else "--connect", end, "--speed", "40 m/s", file=FILE
        )
    members = [fleet.members[name] for name in names]
    fleet.wait(
        lambda: all(
            m.phase == "attached"
            and all(m.heard.get(o.name) == o.record for o in members if o is not m)
            for m in members
        ),
        "that all attach and know all",
    )
    assert len({m.record["place"]["x"] for m in members}) == 3


def test_two_processes_of_one_name(fleet, tmp_path, capfd):
    """The second is told so, and ends before it has said anything."""
    trial = Trial(fleet, tmp_path)
    trial.start("Fortuna")
    trial.attached("Fortuna")
    status = main(["agent", FILE, "--name", "Fortuna", "--mode", "client", "--connect", trial.end])
    assert status == 2
    assert "a process of Fortuna is on the network already" in capfd.readouterr().err
    assert fleet.members["Fortuna"].reports("refuted") == []


def test_another_mission_is_told_and_not_mixed(fleet, tmp_path):
    """Robots of two scenarios on one router do not reckon with each other."""
    trial = Trial(fleet, tmp_path)
    one = trial.start("Fortuna")
    other = fleet.start("Zephyr", "--mode", "client", "--connect", trial.end, *trial.options,
                        file="harbour-tugs")  # fmt: skip
    fleet.wait(
        lambda: (
            one.phase == other.phase == "attached"
            and all(m.reports("stranger") for m in (one, other))
        ),
        "that both attach, each to its own object",
    )
    assert one.heard == other.heard == {}
    [words] = one.reports("stranger")
    assert words.startswith("Zephyr works on another mission")


def test_a_port_in_use_and_a_router_that_is_not_there(fleet, tmp_path, run):
    """Each a sentence, and exit status 2."""
    trial = Trial(fleet, tmp_path)
    status, _, complaint = run("agent", "--router", "--listen", trial.end)
    assert (status, complaint) == (
        2, f"{trial.end}: the port is in use; choose another with --listen\n",
    )  # fmt: skip


def test_a_real_robot_s_software_drives_it_by_lines_of_json(fleet, tmp_path):
    """Orders come out, events go in; when its software ends the robot under way leaves."""
    trial = Trial(fleet, tmp_path)
    words = ["agent", FILE, "--name", "Fortuna", "--mode", "client", "--connect", trial.end,
             "--body", "stdio"]  # fmt: skip
    with subprocess.Popen(
        [sys.executable, "-m", "swarmgrasp", *words], stdin=subprocess.PIPE,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        go = json.loads(process.stdout.readline())
        assert (go["order"], go["number"]) == ("go", 1)
        tell(process, "at place", order=1)
        fasten = json.loads(process.stdout.readline())
        assert (fasten["order"], fasten["x"]) == ("fasten", go["x"])
        tell(process, "fastened", x=go["x"] + 0.001, y=go["y"], direction=go["direction"])
        tell(process, "leave")
        assert json.loads(process.stdout.readline())["order"] == "let go"
        tell(process, "loosened")
        assert json.loads(process.stdout.readline())["order"] == "halt"
        said = process.communicate(timeout=60)[1]
    assert re.search(r"Fortuna is attached: quality 4\d\d\.\d\d kN certified", said)
    assert said.splitlines()[-1].endswith("Fortuna leaves")
    assert process.returncode == 0


def tell(process, event, **more):
    """Tell a robot something as its software does."""
    process.stdin.write(json.dumps({"event": event, **more}) + "\n")
    process.stdin.flush()


@pytest.mark.long
@pytest.mark.parametrize(("robots", "lease", "silent"), [(20, 3, 3.5), (100, 10, 16)])
def test_many_processes(fleet, tmp_path, robots, lease, silent):
    """They join by tens and attach; a tenth is killed; none is lost, doubled or misplaced."""
    trial = Trial(fleet, tmp_path, lease=lease, silent=silent, file=RAFT)
    planner = ProblemPlanner(load_scenario(RAFT).problem())
    names = [f"Robot{k:02}" for k in range(robots)]
    for name in names:
        trial.start(name, "--waits", state=False)
    fleet.wait(lambda: all(len(m.sees) == robots - 1 for m in trial.robots), "that all see all",
               patience=600.0)  # fmt: skip
    for k in range(0, robots, 10):
        ask(trial.end, planner.mission, names[k : k + 10], "join")
        trial.attached(*names[k : k + 10])
    trial.check(planner, spacing=4.0)
    for name in names[: robots // 10]:
        trial.seen_ended(name, fleet.kill(name))
    trial.attached(*names)
    trial.check(planner, spacing=4.0)


LOSSY = "ip link set lo up && tc qdisc add dev lo root netem delay 20ms 5ms loss 5%"


@pytest.mark.long
def test_the_demo_on_a_network_that_loses_and_delays():
    """In a network namespace of its own, where the machine allows one."""
    alone = ["unshare", "-n", "sh", "-c"]
    tried = subprocess.run([*alone, LOSSY], capture_output=True, text=True, check=False)
    if tried.returncode:
        pytest.skip(f"this machine makes no lossy network: {tried.stderr.strip()}")
    demo = f"{LOSSY} && exec {sys.executable} -m swarmgrasp agents demo"
    done = subprocess.run([*alone, demo], capture_output=True, text=True, check=False, timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.long
def test_the_demo_tells_its_story_and_ends_as_one_computer_would(tmp_path):
    """Killed, stopped, split and healed: no difference."""
    story = []
    planner = ProblemPlanner(load_example(FILE).problem())
    assert Demo(FILE, planner, 12, main, tmp_path, story.append).run() == []
    assert any("gives way to" in words for words in story)
