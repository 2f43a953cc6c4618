"""Thrusters that a scenario gives by their allocation matrix."""

from typing import Annotated, Literal

from pydantic import Discriminator, Field, Tag

from swarmgrasp.errors import RobotInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.scenario.fields import FARTHEST, STRONGEST, Label, Number, Section
from swarmgrasp.scenario.measures import Measure
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.matrix import checked_allocation, robots_from

SignedForce = Annotated[Number, Field(ge=-STRONGEST, le=STRONGEST), Measure("force")]
Entry = Annotated[Number, Field(ge=-FARTHEST, le=FARTHEST)]


def _kind(value: object) -> str:
    """Tell a pair from one number, to choose a branch."""
    return "pair" if isinstance(value, list) else "value"


ColumnLimit = Annotated[
    Annotated[SignedForce, Tag("value")]
    | Annotated[list[SignedForce], Field(min_length=2, max_length=2), Tag("pair")],
    Discriminator(_kind),
]


class AllocationSection(Section):
    """Thrusters by their allocation matrix, on board."""

    matrix: list[list[Entry]] = Field(
        min_length=3,
        max_length=3,
        description="Rows surge, sway [1] and yaw [units.length] about the origin of the outline, "
        "x forward: what each column makes per unit of force. One of yaw alone is a pure torque.",
        examples=[[[1, 0], [0, 1], [0, 3]]],
    )
    limits: list[ColumnLimit] = Field(
        description="For each column the largest force, both ways, or [lowest, highest] "
        "[units.force].",
        examples=[[60, [-40, 51]]],
    )
    names: list[Label] | None = Field(None, description="One a column.", examples=[["bow", "gyro"]])
    frame: Literal["ENU", "NED"] | None = Field(
        None,
        description="ENU: sway to port, yaw counter-clockwise; NED: sway to starboard, yaw "
        "clockwise. That of the file when left out.",
    )


def allocated(
    section: AllocationSection, metres: float, newtons: float, frame: Literal["ENU", "NED"],
    outline: Outline,
) -> list[Robot]:  # fmt: skip
    """Return the thrusters of a matrix.

    Parameters
    ----------
    section : AllocationSection
    metres, newtons : float
        What the file's units are.
    frame : {"ENU", "NED"}
        Of the file.
    outline : Outline

    Raises
    ------
    RobotInvalid
        If the matrix has faults, or lines of action run past the outline.
    """
    surge, sway, yaw = section.matrix
    if len({len(surge), len(sway), len(yaw)}) > 1:
        raise RobotInvalid(
            f"the rows have {len(surge)}, {len(sway)} and {len(yaw)} numbers; they should have as "
            "many"
        )
    limits = [
        [newtons * force for force in limit] if isinstance(limit, list) else newtons * limit
        for limit in section.limits
    ]
    rows = [surge, sway, [metres * arm for arm in yaw]]
    asked = checked_allocation(rows, limits, section.names, section.frame or frame)
    return robots_from(asked, outline)
