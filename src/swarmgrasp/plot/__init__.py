"""Pictures: plan view, wrench sets, a newcomer's landscape, capability, sensitivities."""

from swarmgrasp.plot.capability import capability_diagram
from swarmgrasp.plot.capability_numbers import numbers_diagram
from swarmgrasp.plot.forces import forces_plan
from swarmgrasp.plot.landscape import landscape
from swarmgrasp.plot.plan import plan
from swarmgrasp.plot.save import save, svg
from swarmgrasp.plot.sensitivity import sensitivity_plan
from swarmgrasp.plot.study import study_picture
from swarmgrasp.plot.thrust_use import thrust_use_picture
from swarmgrasp.plot.wrenches import wrench_sets

__all__ = [
    "capability_diagram",
    "forces_plan",
    "landscape",
    "numbers_diagram",
    "plan",
    "save",
    "sensitivity_plan",
    "study_picture",
    "svg",
    "thrust_use_picture",
    "wrench_sets",
]
