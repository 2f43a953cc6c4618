"""What robots must know of each other: final quality against what is communicated."""

from swarmgrasp.agents.knowledge.cases import Case
from swarmgrasp.agents.knowledge.curve import (
    FULL,
    QUICK,
    Curve,
    Line,
    Lines,
    Size,
    measure,
    tasks_of,
)

__all__ = ["FULL", "QUICK", "Case", "Curve", "Line", "Lines", "Size", "measure", "tasks_of"]
