"""How fast robots that are processes on this machine agree, and how much they say.

    python benchmarks/agents_network.py [--robots 20] [--kill 3]

Prints, with the load of the machine: from the message that a robot joins until all others have
its first decision; from kill -9 until all others know, and from SIGSTOP, beside the lease; what a
robot sends for each join, its signs of life apart; whether the places are those of one computer.
"""

import argparse
import os
import signal
import statistics
import time
from pathlib import Path

from swarmgrasp.agents.network.fleet import Fleet, ask, free_ports
from swarmgrasp.agents.network.plain import place_data
from swarmgrasp.agents.protocol import Phase, ProblemPlanner, Record, Row
from swarmgrasp.cli import main
from swarmgrasp.scenario import load_scenario

PATIENCE = 400.0
BEAT = 23
"""Bytes of a sign of life of a robot with a name of seven letters."""

FILE = Path(__file__).parent / "raft.yaml"


def at(member, name, phase):
    """Return when a robot first had another's word that it is in a phase [s]."""
    for told in member.told:
        record = told.get("heard") or told.get("record") or {}
        if record.get("name") == name and record["phase"] == phase:
            return told["clock"]
    return None


def tell(what, seconds):
    """Print the middle and the largest of some times [s]."""
    median, most = 1e3 * statistics.median(seconds), 1e3 * max(seconds)
    print(f"{what}: {median:.0f} ms at the median, {most:.0f} ms at most", flush=True)


def spread(members, since, until):
    """Return, for each robot, the time from its own word until all others have another of it."""
    spans = []
    for member in members:
        begin = at(member, member.name, since)
        seen = [at(other, member.name, until) for other in members if other is not member]
        if begin is not None and all(seen):
            spans.append(max(seen) - begin)
    return spans


def missed(members, name, when):
    """Return when each robot saw that another's process had ended [s]."""
    return [
        next((t["clock"] for t in m.told if t.get("down") == name and t["clock"] > when), 0.0)
        for m in members
    ]


def measure(fleet, file, robots, kill, lease, silent):
    """Start robots, let them join by tens, kill some and stop one, and print what was measured."""
    begin, names = time.monotonic(), [f"Robot{k:02}" for k in range(robots)]
    end = f"tcp/127.0.0.1:{free_ports(1)[0]}"
    options = ["--mode", "client", "--connect", end, "--lease", lease, "--silent", silent,
               "--worth", 0, "--speed", 100, "--fastening", 0.2]  # fmt: skip
    planner = ProblemPlanner(load_scenario(file).problem())
    router = fleet.start("router", "--listen", end, "--lease", lease)
    fleet.wait(lambda: bool(router.told), "a router")
    members = [fleet.start(name, *options, "--waits", file=file) for name in names]
    fleet.wait(lambda: all(len(m.sees) == robots - 1 for m in members), "that all see all",
               patience=PATIENCE)  # fmt: skip
    print(
        f"{robots} clients of a router: all see all after {time.monotonic() - begin:.1f} s",
        flush=True,
    )
    for k in range(0, robots, 10):
        group = members[k : k + 10]
        ask(end, planner.mission, [m.name for m in group], "join")
        fleet.wait(lambda of=group: all(m.phase == "attached" for m in of), "that ten attach",
                   patience=PATIENCE)  # fmt: skip
    pairs = [(m, o) for m in members for o in members if m is not o]
    fleet.wait(lambda: all(m.heard.get(o.name) == o.record for m, o in pairs), "that all know all",
               patience=PATIENCE)  # fmt: skip
    attached = time.monotonic() - begin
    print(f"all attached, by tens, and all know it after {attached:.1f} s", flush=True)
    tell("join to decision known by all", spread(members, "waiting", "coming"))
    tell("attached to known by all", spread(members, "attached", "attached"))
    spans = []
    for name in names[1 : 1 + kill]:
        when = fleet.kill(name)
        left = [m for m in members if m.process.is_alive()]
        fleet.wait(lambda n=name, w=when, of=left: all(missed(of, n, w)), f"that {name} is missed")
        spans.append(max(missed(left, name, when)) - when)
    tell("kill -9 seen by all", spans)
    when = fleet.signal(names[-1], signal.SIGSTOP)
    left = [m for m in members if m.process.is_alive() and m.name != names[-1]]
    fleet.wait(lambda: all(missed(left, names[-1], when)), "that a hang is seen")
    print(f"hang seen by all after {max(missed(left, names[-1], when)) - when:.2f} s, "
          f"lease {lease:g} s")  # fmt: skip
    check(members, planner)
    took = time.monotonic() - begin
    fleet.end()
    sent = [t["traffic"]["sent_bytes"] for m in members for t in m.told if "traffic" in t]
    beats = BEAT * took * 3.5 / silent
    each = (statistics.median(sent) - beats) / robots
    print(f"sent by a robot for each join: {each:.0f} bytes, beside {beats:.0f} of signs of life")
    load = ", ".join(f"{value:.1f}" for value in os.getloadavg())
    print(f"{took:.1f} s in all; load of the machine {load} on {os.cpu_count()} cores")


def check(members, planner):
    """Compare the places with those of one robot placed after the other."""
    rows, same = list(planner.present), 0
    for member in sorted(members, key=lambda m: (m.record["ticket"], m.name)):
        place = planner.place(tuple(rows), (), planner.who(Record(member.name, 1, 0, Phase.LEFT)))
        rows.append(Row(member.name, member.record["ticket"], place))
        same += place_data(place) == member.record["place"]
    print(f"{same} of {len(members)} places are those of one robot placed after the other")


def run():
    """Measure as the command line asks."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--robots", type=int, default=20)
    parser.add_argument("--kill", type=int, default=3)
    parser.add_argument("--lease", type=float, default=3.0)
    parser.add_argument("--silent", type=float, default=3.5)
    asked = parser.parse_args()
    with Fleet(main) as fleet:
        measure(fleet, str(FILE), asked.robots, asked.kill, asked.lease, asked.silent)


if __name__ == "__main__":
    run()
