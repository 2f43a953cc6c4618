"""The swarms and placements of data/cases.json, computed by other programs."""

import json
from pathlib import Path

from swarmgrasp import Newcomer, Outline, Robot, Swarm

CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
QUALITIES = {case["name"]: case for case in CASES["qualities"]}
PLACEMENTS = {case["name"]: case for case in CASES["placements"]}


def swarm_of_case(case):
    """Return the swarm of a case."""
    robots = [Robot(tuple(r["contact"]), r["direction"], r["limit"]) for r in case["robots"]]
    return Swarm(Outline(case["outline"]), robots, case["characteristic_length"])


def newcomer_of_case(case):
    """Return the newcomer of a placement case."""
    return Newcomer(case["new"]["limit"], case["new"]["attachment"], case["new"]["half_angle"])
