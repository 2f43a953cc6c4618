"""What wind, current and waves have in common: bearings, the hull's size, and lines of action."""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment.limits import BEARING, Range
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.ranges import array_of, is_number, shown

Array = NDArray[np.float64]


def keep_floats(part: object) -> None:
    """Keep the numbers of a part, which are known to be right, as floats."""
    numbers = {name: value for name, value in vars(part).items() if is_number(value)}
    vars(part).update({name: float(value) for name, value in numbers.items()})


def numbers_in(values: ArrayLike, name: str, known: Range) -> Array:
    """Return numbers in a range as an array."""
    found = array_of(values)
    if found is None or not ((found >= known.low) & (found <= known.high)).all():
        raise EnvironmentInvalid(
            f"the {name} are {shown(values)}; they should be {known.low:g} <= number <= "
            f"{known.high:g} [{known.unit}]"
        )
    return found


def folded_of(bearings: ArrayLike) -> tuple[Array, Array]:
    """Return bearings within [-pi, pi], and how far each is from ahead, either side."""
    wanted = numbers_in(bearings, "bearings", BEARING)
    turned = wanted - 2.0 * math.pi * np.round(wanted / (2.0 * math.pi))
    return turned, np.abs(turned)


def length_of(outline: Outline) -> float:
    """Return the outline's length over all [m]."""
    return float(np.ptp(outline.vertices[:, 0]))


def beam_of(outline: Outline) -> float:
    """Return the outline's beam over all [m]."""
    return float(np.ptp(outline.vertices[:, 1]))


def midship_of(outline: Outline) -> Array:
    """Return the middle (2,) [m] of the outline's bounding box."""
    return np.asarray(0.5 * (outline.vertices.min(axis=0) + outline.vertices.max(axis=0)))


def wrench_of(outline: Outline, surge: Array, sway: Array, arm: Array) -> Array:
    """Return forces whose line is `arm` [m] forward of midship as wrenches about the origin."""
    x, y = midship_of(outline) - outline.origin
    return np.stack([surge, sway, (x + arm) * sway - y * surge], axis=-1)
