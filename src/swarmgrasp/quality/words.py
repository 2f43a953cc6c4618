"""A wrench, a force and a list of names in plain words."""

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.ranges import array_of, shown

MENTIONED = 0.25
"""Share of a unit direction below which a component goes unmentioned."""
WAYS: Final = (("ahead", "aft"), ("to port", "to starboard"))
UNITS: Final = ((1e6, 1e6, "MN"), (1e3, 1e3, "kN"), (1e-2, 1.0, "N"), (0.0, 1e-3, "mN"))
"""Least force [N] told in a unit, its size [N], and its name."""


def wrench_words(direction: ArrayLike) -> str:
    """Say how a wrench would move the object, the strongest part first.

    Parameters
    ----------
    direction : (3,)
        Surge, sway and yaw in the metric's coordinates: x forward, y to port, yaw
        counter-clockwise. Need not be a unit vector.

    Raises
    ------
    WrenchInvalid
        If it is not three finite numbers.

    Examples
    --------
    >>> wrench_words([0.0, -1.0, 0.0])
    'moving to starboard'
    >>> wrench_words([-0.5, 0.0, 0.8])
    'turning to port while moving aft'
    >>> wrench_words([0.6, -0.7, -0.4])
    'moving to starboard and ahead while turning to starboard'
    >>> wrench_words([0.0, 0.0, 0.0])
    'no wrench'
    """
    parts = array_of(direction)
    if parts is None or parts.shape != (3,) or not np.isfinite(parts).all():
        raise WrenchInvalid(
            f"the direction is {shown(direction)}; it should be three finite numbers"
        )
    size = float(np.linalg.norm(parts))
    if size == 0.0:
        return "no wrench"
    order = [int(i) for i in np.argsort(-np.abs(parts), kind="stable")]
    told = [i for i in order if abs(parts[i]) >= MENTIONED * size]
    moving = " and ".join(WAYS[i][int(parts[i] < 0.0)] for i in told if i < 2)
    said = [f"moving {moving}"] if moving else []
    if 2 in told:
        turning = f"turning to {'port' if parts[2] > 0.0 else 'starboard'}"
        said.insert(0 if told[0] == 2 else 1, turning)
    return " while ".join(said)


def force_words(value: float, whole: float | None = None, unit: str = "") -> str:
    """Say a force with its unit, to four digits.

    Parameters
    ----------
    value : float [N]
    whole : float [N], optional
        What it is a part of: the unit and the last digit are those of the whole.
    unit : str
        Follows the unit of force: " m" for a torque.

    Examples
    --------
    >>> force_words(229_220.4), force_words(0.0702534), force_words(0.0)
    ('229.2 kN', '0.07025 N', '0 N')
    >>> force_words(-1e-9, whole=2e3), force_words(-150.0, 2e3, " m")
    ('0 kN', '-0.150 kN m')
    """
    size = abs(value if whole is None else whole)
    factor, name = next((f, n) for least, f, n in UNITS if (size or 1.0) >= least)
    return f"{digits(value / factor, size / factor)} {name}{unit}"


def digits(value: float, size: float) -> str:
    """Write a number with the decimals that give a size four digits, never as -0.

    Examples
    --------
    >>> digits(2.0, 2.0), digits(0.5, 100.0), digits(0.0, 0.0)
    ('2.000', '0.5', '0')
    """
    if size == 0.0:
        return "0"
    decimals = max(0, 3 - math.floor(math.log10(size)))
    rounded = round(value, decimals)
    return f"{rounded:.{decimals}f}" if rounded else "0"


def list_words(names: Sequence[str]) -> str:
    """Join names as in a sentence.

    Examples
    --------
    >>> list_words(["Ajax"]), list_words(["Ajax", "Boreas"]), list_words("abc")
    ('Ajax', 'Ajax and Boreas', 'a, b and c')
    """
    if len(names) < 2:
        return "".join(names)
    return f"{', '.join(names[:-1])} and {names[-1]}"


def share_words(share: float) -> str:
    """Say a share in percent, to three digits, or one where it is tiny.

    Examples
    --------
    >>> share_words(1.0806), share_words(0.975), share_words(0.0), share_words(2.2e-7)
    ('108 %', '97.5 %', '0 %', '0.00002 %')
    """
    value = 100.0 * share
    if value == 0.0:
        return "0 %"
    power = math.floor(math.log10(abs(value)))
    return f"{value:.{max(0, 2 - power if power >= -1 else -power)}f} %"
