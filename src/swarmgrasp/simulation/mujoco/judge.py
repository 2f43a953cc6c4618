"""Whether MuJoCo holds what the quality says is held, and no more."""

import math
from dataclasses import dataclass, replace
from importlib.metadata import version

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.forces import forces
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told
from swarmgrasp.quality import Quality
from swarmgrasp.ranges import kind_faults
from swarmgrasp.simulation.hull import Hull, inverse_of
from swarmgrasp.simulation.mujoco.world import World

Array = NDArray[np.float64]
FACTORS = (0.99, 1.0, 1.01)
"""Sizes of disturbances, relative to the quality."""
DURATION = 60.0
"""Of a trial at most [s]."""
FARTHEST = 100.0
"""Way, in extents of the object, on which the weakest wrench alone would move it meanwhile."""
FASTEST = 1e10
"""Acceleration [m/s^2, rad/s^2] up to which MuJoCo counts."""
STEPS = 600
"""Of a trial."""
STILL = 1e-6
"""Way that counts as none, relative to that on which the weakest wrench alone moves the object.

The quality of robots that steer is certified to 1e-9; a hundredth of the wrench goes 0.01 of it.
"""


@dataclass(frozen=True, eq=False)
class Trial(Frozen, Told):
    """What came of one disturbance.

    Attributes
    ----------
    factor : float
        Its size, relative to the quality.
    net : float [N]
        The wrench that was left of disturbance and robots at the start, in the metric.
    distance : float [m]
        Of the outline's origin from where it was, at the end.
    turn : float [rad]
        By which the object had turned.
    is_held : bool
    """

    factor: float
    net: float
    distance: float
    turn: float
    is_held: bool


@dataclass(frozen=True, eq=False)
class Judgement(Frozen, Told):
    """What MuJoCo says of a quality; true if the same.

    Attributes
    ----------
    quality : Quality
    hull : Hull
    duration : float [s]
        Of each trial.
    trials : tuple of Trial
        By rising factors.
    version : str
        Of MuJoCo.
    """

    quality: Quality
    hull: Hull
    duration: float
    trials: tuple[Trial, ...]
    version: str

    def __bool__(self) -> bool:
        """Tell whether what is held is what the quality says."""
        return all(trial.is_held == (trial.factor <= 1.0) for trial in self.trials)


def judge(quality: Quality, hull: Hull) -> Judgement:
    """Let MuJoCo say whether a quality is right.

    Against the swarm as it is in the worst case comes a disturbance along the weakest wrench, for
    60 s, or less if the object is light; the robots answer it with the forces of `forces`, which
    stay. Up to the quality the object should stay where it is, and beyond it move off.

    Parameters
    ----------
    quality : Quality
        As `quality` finds it by any criterion.
    hull : Hull

    Raises
    ------
    PackageMissing
        Without MuJoCo.
    SimulationInvalid
        If a value is none of these, or the quality is 0: nothing is held in some direction; or if
        the object is too light for MuJoCo.

    Examples
    --------
    >>> import math
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> from swarmgrasp import quality as quality_of
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> crowd = [Robot((x, y), math.atan2(-y, -x) + turn) for x, y, turn in (
    ...     (1, 0, 0.5), (1, 0, -0.5), (0, 1, 0.5), (0, 1, -0.5), (-1, -1, 0.5), (-1, -1, -0.5))]
    >>> found = judge(quality_of(Swarm(square, crowd)), Hull.ashore(square, 30.0))
    >>> bool(found), [trial.is_held for trial in found.trials]
    (True, [True, True, False])
    """
    faults = kind_faults(quality, Quality, "quality(swarm)")
    faults += kind_faults(hull, Hull, "Hull.ashore(outline, mass)")
    if not faults and quality.value <= quality.noise:
        faults.append(
            "the quality is 0, so there is a direction in which nothing is held, and nothing to "
            "judge; add robots until they have force closure"
        )
    if faults:
        raise SimulationInvalid(faults)
    extent = quality.worst_swarm.outline.extent
    bare = replace(hull, added=(0.0, 0.0, 0.0))
    rates = inverse_of(bare.matrix) @ quality.weakest_wrench
    _check_rates(rates, hull)
    start = _way(rates, extent)
    duration = min(DURATION, math.sqrt(2.0 * FARTHEST * extent / start))
    still = STILL * 0.5 * start * duration**2
    trials = tuple(_tried(quality, hull, factor, duration, still) for factor in FACTORS)
    return Judgement(quality, hull, duration, trials, version("mujoco"))


def _check_rates(rates: Array, hull: Hull) -> None:
    """Raise `SimulationInvalid` if the weakest wrench alone is too much for MuJoCo."""
    fastest = float(np.abs(rates).max())
    if fastest > FASTEST:
        raise SimulationInvalid(
            f"an object of {hull.mass:.3g} kg is too light to judge: the weakest wrench alone "
            f"would give it {fastest:.2g} m/s^2 or rad/s^2, and MuJoCo counts up to {FASTEST:.0e}; "
            f"give it {fastest / FASTEST:.2g} times the mass and inertia, or more"
        )


def _tried(quality: Quality, hull: Hull, factor: float, duration: float, still: float) -> Trial:
    """Return what comes of a disturbance in a time [s]; held is what stays within a way [m]."""
    swarm, load = quality.worst_swarm, np.array(quality.criterion.load)
    wanted = factor * quality.weakest_wrench
    answer = forces(swarm, wanted, load=load)
    world = World(swarm, hull, step=duration / STEPS)
    acting = load - wanted
    world.order(answer.vectors, acting)
    net = float(np.linalg.norm(world.net * swarm.scale))
    pose = world.advance(answer.vectors, acting, steps=STEPS)
    x, y, turn = pose.tolist()
    is_held = _way(pose, swarm.outline.extent) <= still
    return Trial(factor, net, math.hypot(x, y), abs(turn), is_held)


def _way(motion: Array, extent: float) -> float:
    """Return how far [m] a motion (3,) [m, m, rad] takes the object, or its ends by turning."""
    x, y, turn = motion.tolist()
    return float(max(math.hypot(x, y), abs(turn) * extent))
