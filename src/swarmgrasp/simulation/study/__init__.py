"""Studies: many runs that are alike but for their seeds, on one machine or on many."""

from swarmgrasp.simulation.study.gather import Gathered, gather, rows
from swarmgrasp.simulation.study.gusts import Gusts
from swarmgrasp.simulation.study.kinds import KINDS
from swarmgrasp.simulation.study.losses import Losses
from swarmgrasp.simulation.study.machines import Machines, machines_at
from swarmgrasp.simulation.study.plan import Plan, read_plan
from swarmgrasp.simulation.study.sizes import Sizes
from swarmgrasp.simulation.study.story import Story
from swarmgrasp.simulation.study.study import Column, ColumnHead, Findings, Study
from swarmgrasp.simulation.study.together import PlacedTogether
from swarmgrasp.simulation.study.work import run_plan

__all__ = [
    "KINDS",
    "Column",
    "ColumnHead",
    "Findings",
    "Gathered",
    "Gusts",
    "Losses",
    "Machines",
    "PlacedTogether",
    "Plan",
    "Sizes",
    "Story",
    "Study",
    "gather",
    "machines_at",
    "read_plan",
    "rows",
    "run_plan",
]
