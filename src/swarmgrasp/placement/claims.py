"""What an answer file says, checked for form only."""

import json
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from swarmgrasp.errors import AnswerInvalid

Point = tuple[float, float]


class _Form(BaseModel):
    """Strict: no number from text, nothing infinite, nothing unknown."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, frozen=True)


class RobotClaim(_Form):
    """A robot in contact."""

    contact: Point
    direction: float
    limit: float = Field(gt=0.0)
    name: str
    mounted: bool


class StretchClaim(_Form):
    """A stretch of the boundary by arc length."""

    start: float = Field(ge=0.0)
    end: float = Field(ge=0.0)
    name: str


class ZoneClaim(StretchClaim):
    """Where a newcomer may attach, and how."""

    attachment: Literal["push", "pull", "free"] | None
    half_angle: float | None
    directions: Point | None


class NewcomerClaim(_Form):
    """The newcomer."""

    limit: float = Field(gt=0.0)
    attachment: Literal["push", "pull", "free"]
    half_angle: float | None
    name: str


class RunnerUpClaim(_Form):
    """The best robot in another place."""

    robot: RobotClaim
    quality: float = Field(ge=0.0)
    place: str


class ProofClaim(_Form):
    """A convex combination of directions."""

    normals: list[tuple[float, float, float]] = Field(min_length=1)
    weights: list[float] = Field(min_length=1)


class PlacementClaim(_Form):
    """One placement with its question."""

    newcomer: NewcomerClaim
    zones: list[ZoneClaim] | None
    no_go: list[StretchClaim]
    spacing: float = Field(ge=0.0)
    robot: RobotClaim
    place: str
    quality_before: float = Field(ge=0.0)
    quality: float = Field(ge=0.0)
    upper_bound: float = Field(ge=0.0)
    improves: bool
    reason: str
    runners_up: list[RunnerUpClaim]
    proofs: list[ProofClaim]


class OutlineClaim(_Form):
    """The object, counter-clockwise."""

    vertices: list[Point] = Field(min_length=3)
    origin: Point
    edge_names: list[str]


class MetricClaim(_Form):
    """The metric of wrenches."""

    force_weights: Point
    characteristic_length: float = Field(gt=0.0)


class Claims(_Form):
    """A whole answer file."""

    format: Literal["swarmgrasp answer 1"]
    outline: OutlineClaim
    metric: MetricClaim
    robots: list[RobotClaim]
    placements: list[PlacementClaim] = Field(min_length=1)
    digest: str


def read_claims(document: dict[str, Any]) -> Claims:
    """Return the document in typed form.

    Raises
    ------
    AnswerInvalid
        If entries are missing, unknown or of the wrong kind; all of them are named.
    """
    try:
        return Claims.model_validate_json(_as_json(document))
    except ValidationError as error:
        raise AnswerInvalid(
            f"{'.'.join(map(str, fault['loc'])) or 'the file'}: {fault['msg']}"
            for fault in error.errors()
        ) from None


def _as_json(document: dict[str, Any]) -> str:
    """Return the document as JSON text: its lists then stand for tuples, even strictly."""
    return json.dumps(document)
