"""Pictures: the plan view, the wrench sets, and the landscape a newcomer chooses from."""

from swarmgrasp.plot.landscape import landscape
from swarmgrasp.plot.plan import plan
from swarmgrasp.plot.save import save
from swarmgrasp.plot.wrenches import wrench_sets

__all__ = ["landscape", "plan", "save", "wrench_sets"]
