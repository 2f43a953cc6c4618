"""The keys of a scenario file that tell what quality means."""

from typing import Annotated, Literal

from pydantic import ConfigDict, Discriminator, Field, Tag

from swarmgrasp.scenario.fields import Label, Number, Section
from swarmgrasp.scenario.measures import Row

HEAVIEST = 1e15
"""Largest force or torque of a wrench, in the file's units."""

Wrench = Annotated[
    list[Annotated[Number, Field(ge=-HEAVIEST, le=HEAVIEST)]],
    Field(min_length=3, max_length=3),
    Row(("force", "force", "torque")),
]
Wrenches = Annotated[list[Wrench], Field(min_length=1)]


def _kind(value: object) -> str:
    """Tell text from anything else, to choose a branch of "word or wrench"."""
    return "word" if isinstance(value, str) else "value"


Load = Annotated[
    Annotated[Literal["environment"], Tag("word")] | Annotated[Wrench, Tag("value")],
    Discriminator(_kind),
]

WRENCHES = "[fx, fy, tz] about the origin [units.force, units.force, units.force x units.length]"


class TaskSection(Section):
    """A set of wrenches the robots should be able to make.

    Exactly one of `polytope` and `ellipsoid`.
    """

    model_config = ConfigDict(
        json_schema_extra={"oneOf": [{"required": ["polytope"]}, {"required": ["ellipsoid"]}]}
    )

    polytope: Wrenches | None = Field(
        None,
        description=f"The convex hull of no wrench and of these, each {WRENCHES}.",
        examples=[[[100, 0, 0], [-50, 0, 0]]],
    )
    ellipsoid: Wrenches | None = Field(
        None,
        description="All sums of these axes times numbers whose squares add up to at most 1, "
        f"each axis {WRENCHES}.",
        examples=[[[100, 0, 0], [0, 50, 0], [0, 0, 900]]],
    )


Failure = Annotated[
    Annotated[Label, Tag("word")] | Annotated[list[Label], Field(min_length=1), Tag("value")],
    Discriminator(_kind),
]
"""A robot or a group by name, or several that fail together."""


class CriterionSection(Section):
    """What quality means; when left out, what the robots can do as they stand."""

    losing: Annotated[int, Field(strict=True, ge=0, le=10**6)] = Field(
        0, description="After the worst loss of so many robots.", examples=[1]
    )
    failures: list[Failure] | None = Field(
        None,
        min_length=1,
        description="After the worst of these failures: each a robot or a group by name, or a list "
        "of those that fail together.",
        examples=[["bus A", ["Ajax", "Castor"]]],
    )
    worst_case: bool = Field(
        False, strict=True, description="In the worst poses that the tolerances allow."
    )
    load: Load | None = Field(
        None,
        description="The margin left beside a steady load on the object, the wrench "
        f"{WRENCHES}; or beside the steady wind and the current of the environment.",
        examples=["environment", [0, -20, 0]],
    )
    task: TaskSection | None = Field(
        None,
        description="Quality is the largest factor by which this set of wrenches may grow; "
        "without one it is a force.",
    )
