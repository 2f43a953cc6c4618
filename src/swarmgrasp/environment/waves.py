"""The mean drift of waves: the steady part of what a sea does to the object."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment.geometry import (
    beam_of,
    folded_of,
    keep_floats,
    length_of,
    midship_of,
    numbers_in,
    wrench_of,
)
from swarmgrasp.environment.limits import BEARING, BOW_ANGLE, DENSITY, FULLNESS, HEIGHT, PERIOD
from swarmgrasp.environment.loads import WATER
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.outline.outline import check_outline
from swarmgrasp.plain import Plain

GRAVITY = 9.81
"""[m/s^2]"""
MEAN_PERIOD = 1.0 / 1.4049
"""Zero-up-crossing period over peak period, of the sea of DNV-ST-0111: Pierson and Moskowitz's
spectrum, spread by the square of the cosine."""


@dataclass(frozen=True)
class Waves(Plain):
    """A sea, and what of the object meets it; the outline is taken for the waterline.

    Attributes
    ----------
    height : float [m], optional
        Significant height; goes with `period`. Without both the sea is the one that goes with the
        wind, by `sea_of`.
    period : float [s], optional
        Peak period of the spectrum.
    bearing : float [rad], optional
        Where the waves come from, clockwise from the bow; from where the wind comes, when left out.
    bow_angle : float [rad], optional
        Between the centre line and the line from the stem to the waterline a quarter of the beam
        off it; of the outline, when left out.
    aft_fullness : float, optional
        The part of half the length times the beam that the waterplane aft of midship fills; of the
        outline, when left out. The formula counts what is outside [0.85, 1.15] as the nearer end.
    density : float [kg/m^3]
        Of the water.

    Raises
    ------
    EnvironmentInvalid
        If a number is outside its range, or height and period do not go together; all faults at
        once.

    Examples
    --------
    A barge of 80 m in a beam sea of 2 m from starboard is pushed to port:

    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> surge, sway, yaw = Waves().load(barge, math.pi / 2, 2.0, 4.0)
    >>> round(sway)
    144937
    """

    height: float | None = None
    period: float | None = None
    bearing: float | None = None
    bow_angle: float | None = None
    aft_fullness: float | None = None
    density: float = WATER

    def __post_init__(self) -> None:
        """Check the values."""
        faults = DENSITY.faults("density", self.density)
        for name, known in (
            ("height", HEIGHT), ("period", PERIOD), ("bearing", BEARING),
            ("bow_angle", BOW_ANGLE), ("aft_fullness", FULLNESS),
        ):  # fmt: skip
            if getattr(self, name) is not None:
                faults += known.faults(name.replace("_", " "), getattr(self, name))
        if (self.height is None) != (self.period is None):
            faults.append(
                "the height and the period of waves go together; give both, or neither for the sea "
                "that goes with the wind"
            )
        if faults:
            raise EnvironmentInvalid(f"waves: {fault}" for fault in faults)
        keep_floats(self)

    @property
    def goes_with_wind(self) -> bool:
        """Whether the sea is the one that goes with the wind."""
        return self.height is None

    def load(
        self, outline: Outline, bearings: ArrayLike, heights: ArrayLike, periods: ArrayLike
    ) -> NDArray[np.float64]:
        """Compute the wrench of the mean wave drift on the object, as DNV-ST-0111 does for ships.

        With p = density g H^2 / 2, T = 0.712 times the peak period, and for a bearing b of 0 to pi

            X = p B 0.09 h1 h2 f(T / (0.9 L^0.33)),    Y = p L 0.09 sin b f(T / (0.75 B^0.5)),
            N = Y (0.05 - 0.14 b / pi) L  about midship,
            h1 = h_bow + (b / pi) (h_aft - h_bow),   h_bow = 0.8 bow_angle^0.45,
            h_aft = 0.7 aft_fullness^2,    h2 = 0.05 + 0.95 atan(1.45 (b - 1.75)),
            f(t) = 1 for t < 1, and t^-3 exp(1 - t^-3) beyond;

        from port, Y and N change sign.

        Parameters
        ----------
        outline : Outline
            Gives length L and beam B, midship, and the origin that moments are taken about.
        bearings : (...) [rad]
            Where the waves come from, clockwise from the bow.
        heights : (...) [m]
            Significant heights.
        periods : (...) [s]
            Peak periods.

        Returns
        -------
        (..., 3) [N, N, N m]
        """
        check_outline(outline)
        bearing, folded = folded_of(bearings)
        length, beam = length_of(outline), beam_of(outline)
        bow = bow_angle_of(outline) if self.bow_angle is None else self.bow_angle
        full = aft_fullness_of(outline) if self.aft_fullness is None else self.aft_fullness
        h_bow, h_aft = 0.8 * bow**0.45, 0.7 * min(max(full, 0.85), 1.15) ** 2
        h1 = h_bow + folded / math.pi * (h_aft - h_bow)
        h2 = 0.05 + 0.95 * np.arctan(1.45 * (folded - 1.75))
        mean = MEAN_PERIOD * numbers_in(periods, "periods", PERIOD)
        pressure = 0.5 * self.density * GRAVITY * numbers_in(heights, "heights", HEIGHT) ** 2
        surge = pressure * beam * 0.09 * h1 * h2 * _felt(mean / (0.9 * length**0.33))
        sway = pressure * length * 0.09 * np.sin(bearing) * _felt(mean / (0.75 * beam**0.5))
        surge, sway, arm = np.broadcast_arrays(
            surge, sway, (0.05 - 0.14 * folded / math.pi) * length
        )
        return wrench_of(outline, surge, sway, arm)


def bow_angle_of(outline: Outline) -> float:
    """Return the angle [rad] of the line from the stem to the hull a quarter of the beam aside.

    Of port and starboard the mean; pi / 2 for a bow cut off square.

    Examples
    --------
    >>> wedge = Outline([(0, 0), (-40, 10), (-40, -10)])
    >>> round(math.tan(bow_angle_of(wedge)), 9), bow_angle_of(Outline([(0, 0), (1, 0), (1, 1)]))
    (0.25, 1.5707963267948966)
    """
    quarter, stem = 0.25 * beam_of(outline), float(outline.vertices[:, 0].max())
    middle = float(midship_of(outline)[1])
    aft = [
        stem - _farthest_forward(outline.vertices, y) for y in (middle - quarter, middle + quarter)
    ]
    return math.atan2(quarter, 0.5 * sum(aft))


def aft_fullness_of(outline: Outline) -> float:
    """Return the part of half the length times the beam that lies within the outline aft.

    Examples
    --------
    >>> aft_fullness_of(Outline([(-4, -1), (4, -1), (4, 1), (-4, 1)]))
    1.0
    >>> aft_fullness_of(Outline([(0, 0), (-40, 10), (-40, -10)]))
    0.75
    """
    midship = float(midship_of(outline)[0])
    x, y = _cut_aft(outline.vertices, midship).T
    area = 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))
    return area / (0.5 * length_of(outline) * beam_of(outline))


# -- parts --------------------------------------------------------------------------------


def _felt(periods: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the part of a sea's drift that is left, of periods over those up to which all is."""
    beyond = np.maximum(periods, 1.0) ** -3.0
    return np.asarray(beyond * np.exp(1.0 - beyond))


def _farthest_forward(vertices: NDArray[np.float64], y: float) -> float:
    """Return the largest x at which the edges between vertices (m, 2) have a y."""
    starts, ends = vertices, np.roll(vertices, -1, axis=0)
    rises = ends[:, 1] - starts[:, 1]
    crossed = (np.minimum(starts[:, 1], ends[:, 1]) <= y) & (rises != 0.0)
    crossed &= np.maximum(starts[:, 1], ends[:, 1]) >= y
    p, q = starts[crossed], ends[crossed]
    return float((p[:, 0] + (y - p[:, 1]) / rises[crossed] * (q[:, 0] - p[:, 0])).max())


def _cut_aft(vertices: NDArray[np.float64], x: float) -> NDArray[np.float64]:
    """Return the corners of the part of a polygon that has no more than an x."""
    kept = []
    for p, q in zip(vertices, np.roll(vertices, -1, axis=0), strict=True):
        if p[0] <= x:
            kept.append(p)
        if (p[0] - x) * (q[0] - x) < 0.0:
            kept.append(p + (x - p[0]) / (q[0] - p[0]) * (q - p))
    return np.array(kept)
