"""Capability before and after a robot joins."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from swarmgrasp.capability.winds import Capability, capability
from swarmgrasp.environment import Environment
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement import Placement
from swarmgrasp.plain import Answer, picked


@dataclass(frozen=True, eq=False)
class CapabilityJoined(Frozen, Answer):
    """The largest winds held without and with a newcomer in the place found for it.

    Attributes
    ----------
    placement : Placement
    before, after : Capability
    """

    placement: Placement
    before: Capability
    after: Capability

    kind = "capability with newcomer"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data; the curves as those of a `Capability`."""
        asked = ("environment", "losing", "worst_case", "failures", "bearings")
        curves = (
            "intact", "after_loss", "holds_calm", "holds_calm_after_loss",
        )  # fmt: skip
        told = {
            when: {
                **picked(one, *curves),
                "worst_losses": list(map(list, one.worst_losses)),
            }
            for when, one in (("before", self.before), ("after", self.after))
        }
        return {
            "problem": self.placement.problem.to_data(),
            **picked(self.after, *asked),
            **picked(self.placement, "robot", "place"),
            **told,
        }


def capability_joined(
    placement: Placement,
    environment: Environment,
    before: Capability,
    progress: Callable[[int], object] | None = None,
) -> CapabilityJoined:
    """Find what a newcomer adds to a capability.

    Parameters
    ----------
    placement : Placement
        Where it goes.
    environment : Environment
    before : Capability
        Of the swarm that it joins.
    progress : callable, optional
        As for `capability`.
    """
    after = capability(
        placement.swarm_after, environment, before.bearings, before.losing, before.worst_case,
        before.failures, progress,
    )  # fmt: skip
    return CapabilityJoined(placement, before, after)
