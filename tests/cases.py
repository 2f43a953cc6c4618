"""The swarms and placements of data/cases.json, computed by other programs."""

import json
from pathlib import Path

import numpy as np

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


def rounded_tank(corners, robots, decimals, radius=25.0):
    """Return a circle with rounded coordinates and tugs of 40 t that push inward amid its edges."""
    turns = 2.0 * np.pi * np.arange(corners) / corners
    vertices = radius * np.column_stack([np.cos(turns), np.sin(turns)])
    outline = Outline(vertices.round(decimals))
    edges = [k * corners // robots for k in range(robots)]
    contacts = [outline.on_edge(edge, 0.5 * outline.lengths[edge]) for edge in edges]
    return Swarm(outline, [Robot(at.point, at.inward, 392_266.0) for at in contacts])
