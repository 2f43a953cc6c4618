"""How the quality changes when one robot moves, turns, or is made stronger (T19)."""

from dataclasses import dataclass, field
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import CriterionInvalid, ForceSetUnsupported
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told, picked
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.criterion import Criterion, Keywords, criterion_of
from swarmgrasp.quality.heights import Array, Heights
from swarmgrasp.quality.max_transfer import Quality, quality
from swarmgrasp.quality.opposed import opposition
from swarmgrasp.quality.robot_sets import RobotSets
from swarmgrasp.quality.set_slopes import KINDS, set_slopes
from swarmgrasp.quality.shares import shares_at
from swarmgrasp.quality.task import Polytope
from swarmgrasp.quality.weakest_facets import TIED, weakest_facets
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.swarm import check_swarm
from swarmgrasp.visible import Visible

KINK = 1e-7
"""Difference of two slopes that is a kink, relative to how fast the robot's wrench changes."""
ROUGH_KINK = 1e-5
"""The same of robots that have force sets, whose slopes are found less closely."""
ROUNDING = 1e-12
"""Share of what a robot's wrench changes by, along a facet's normal, that is none."""


@dataclass(frozen=True, eq=False)
class Sensitivities(Frozen, Told, Visible):
    """How fast the quality rises when one robot changes and the others stay.

    Row i is of the robot ``swarm.names[i]``. Each array has two columns, for the one way and for
    the other: both say what is gained by going there, so where the quality is smooth they are
    opposite, and where both are negative the robot stands on a ridge. With a task, quality has no
    unit [1].

    Attributes
    ----------
    contact : (n, 2) [N/m]
        Per metre that the contact moves clockwise along the boundary, and counter-clockwise;
        at a corner onto the one edge or the other. nan for mounted robots, which do not move.
    direction : (n, 2) [N/rad]
        Per radian that the force turns clockwise, and counter-clockwise; nan for couples.
    limit : (n, 2) [N/N]
        Per newton that the limit falls, and rises.
    reverse_limit : (n, 2) [N/N]
        Per newton that the reverse limit falls, and rises; nan for robots without.
    start, end : (n, 2) [N/rad]
        Per radian that the clockwise, or the other, end of what a robot steers turns clockwise, and
        counter-clockwise; nan for robots that do not steer, or all around.
    kinks : (n, 6) bool
        Whether these have two slopes that are not opposite.
    quality : Quality
        What they are the slopes of.
    weakest : (m, 3)
        Unit normals of all facets as weak as the weakest, in the metric's coordinates; of force
        sets those that a search finds.
    """

    contact: Array
    direction: Array
    limit: Array
    reverse_limit: Array
    start: Array
    end: Array
    kinks: NDArray[np.bool_]
    quality: Quality
    weakest: Array
    swarm: Swarm = field(repr=False)

    def to_data(self) -> dict[str, Any]:
        """Return the slopes as plain data, those of each robot by its name."""
        slopes = picked(self, *KINDS, "kinks")
        rows = zip(*slopes.values(), strict=True)
        return {
            self.swarm.names[i]: dict(zip(slopes, row, strict=True)) for i, row in enumerate(rows)
        }

    @property
    def direction_per_degree(self) -> Array:
        """(n, 2) [N/deg]: `direction`, per degree."""
        return np.radians(self.direction)

    @property
    def is_ridge(self) -> bool:
        """Whether several facets, or directions, are equally weak."""
        return len(self.weakest) > 1


def sensitivities(swarm: Swarm, **keywords: Unpack[Keywords]) -> Sensitivities:
    """Compute how fast the quality rises when one robot moves, turns, or is made stronger.

    The slopes are exact, and one-sided where the quality has a kink (T19): at a corner, where
    several facets are equally weak, or where more than two robots span the weakest one. They
    take the quality itself and a list of those facets, which costs about as much for 1 000 robots
    as some hundred qualities. Of robots that steer, reverse or rub, and of groups that may be
    lost, directions as weak as the weakest are searched for: one that is missed leaves a slope too
    high.

    Parameters
    ----------
    swarm : Swarm
        Of any size, degenerate or not. At quality 0 a slope is 0, or positive where the
        slightest move gives force closure.
    losing, load, task, failures
        As for `Criterion`.

    Returns
    -------
    Sensitivities

    Raises
    ------
    SwarmInvalid
        If it is no `Swarm`.
    CriterionInvalid
        If a term is outside its range, or the worst case is asked for.
    ForceSetUnsupported
        If the quality is 0 and not all robots push along one ray each.

    Examples
    --------
    Four unit robots balance on a square, so that it is equally weak in eight directions:
    whichever robot moves, whichever way, one of them gets weaker.

    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, -1), -pi / 2)]
    >>> grasp = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> found = sensitivities(grasp)
    >>> found.contact[0].round(4).tolist(), found.kinks[0].tolist(), len(found.weakest)
    ([-0.211, -0.8704], [True, True, True, False, False, False], 8)

    Where nobody turns the object to starboard, quality is 0, and one metre counter-clockwise for
    any of the first four would give 1 N:

    >>> centred = [((1, 0), 0), ((-1, 0), pi), ((0, 1), pi / 2), ((0, -1), -pi / 2)]
    >>> crew = [Robot(c, a) for c, a in [*centred, ((1, 0.5), pi / 2)]]
    >>> grasp = Swarm(square, crew, characteristic_length=1.0)
    >>> sensitivities(grasp).contact.round(4).tolist()
    [[0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 0.0]]
    """
    check_swarm(swarm)
    criterion = criterion_of("sensitivities", keywords)
    if criterion.worst_case:
        raise CriterionInvalid(
            "worst_case is True; sensitivities are of robots whose poses are known: leave it out, "
            "or ask for those of quality(swarm, worst_case=True).worst_swarm"
        )
    found = quality(swarm, **keywords)
    aim = Aim(swarm, criterion)
    if isinstance(aim.robots, RobotSets):
        check_held(found)
        slopes, largest, facets = set_slopes(
            aim, found.value, found.direction, _tangents(swarm), aim.robots.failing
        )
        share = ROUGH_KINK
    else:
        share = KINK
        slopes, largest = np.full((2, len(KINDS), 2, len(swarm)), np.nan)
        facets, slopes[:3], largest[:3] = _slopes(_heights(swarm, criterion), found, _moves(swarm))
    slopes[0, :, swarm.mounted] = np.nan
    kinks = np.abs(slopes.sum(axis=1)) > share * largest.max(axis=1)
    slopes[1, :, list(swarm.rare.couples)] = np.nan
    slopes[2:4] /= swarm.nearness
    columns = {k: np.ascontiguousarray(kind.T) for k, kind in zip(KINDS, slopes, strict=True)}
    return Sensitivities(
        **columns, kinks=kinks.T.copy(), quality=found, weakest=facets, swarm=swarm
    )


def check_held(found: Quality) -> None:
    """Raise `ForceSetUnsupported` where the quality of robots that have force sets is 0."""
    if found.value == 0.0:
        raise ForceSetUnsupported(
            "the quality is 0; its slopes are known for robots that push along one ray each, "
            "without groups that may be lost, and some of these do not: ask for the quality of "
            "the swarm with one robot moved"
        )


def _heights(swarm: Swarm, criterion: Criterion) -> Heights:
    """Return a criterion over plain arrays, in the metric's coordinates."""
    task = np.zeros((0, 3)) if criterion.task is None else criterion.task.generators * swarm.scale
    load = np.array(criterion.load) * swarm.scale
    is_polytope = isinstance(criterion.task, Polytope)
    return Heights(swarm.scaled_generators, load, criterion.losing, task, is_polytope)


def _moves(swarm: Swarm) -> Array:
    """Return how the generators change: (3, 2, n, 3) in the metric's coordinates.

    Of each kind in `KINDS`, per metre, radian or newton, the one way and the other.
    """
    outline, limits = swarm.outline, swarm.limits
    c, s = np.cos(swarm.directions), np.sin(swarm.directions)
    arms = swarm.contacts - outline.origin
    moves = np.zeros((3, 2, len(swarm), 3))
    for way, tangents in enumerate(_tangents(swarm)):
        moves[0, way, :, 2] = limits * (tangents[:, 0] * s - tangents[:, 1] * c)
    moves[1, 1] = limits[:, None] * np.column_stack([-s, c, arms[:, 0] * c + arms[:, 1] * s])
    moves[2, 1] = swarm.generators / limits[:, None]
    moves[1:, 0] = -moves[1:, 1]
    return moves * swarm.scale


def _tangents(swarm: Swarm) -> tuple[Array, Array]:
    """Return the ways (n, 2) along the boundary from each contact, clockwise and the other."""
    outline = swarm.outline
    arcs = outline.nearest(swarm.contacts)[1]
    starts = outline.corner_arc_lengths
    edges = np.clip(np.searchsorted(starts, arcs, side="right") - 1, 0, len(outline) - 1)
    is_start = arcs - starts[edges] <= outline.tolerance
    is_end = starts[edges + 1] - arcs <= outline.tolerance
    along = outline.inward_normals - 0.5 * np.pi
    before, after = (along[(edges + step) % len(outline)] for step in (-1 * is_start, 1 * is_end))
    ways = [np.column_stack([np.cos(turn), np.sin(turn)]) for turn in (before, after)]
    return -ways[0], ways[1]


def _slopes(heights: Heights, found: Quality, moves: Array) -> tuple[Array, Array, Array]:
    """Compute the slopes of the quality along moves (3, 2, n, 3).

    Returns
    -------
    facets : (m, 3)
        Normals of those that are weakest.
    slopes : (3, 2, n)
    largest : (3, 2, n)
        What the slopes could be at most.
    """
    slopes, sizes = np.zeros(moves.shape[:3]), np.linalg.norm(moves, axis=3)
    normal = found.direction[None]
    is_far_below = found.value == 0.0 and heights.at(normal)[0][0] < -TIED * heights.weight
    if is_far_below or _is_hopeless(heights, found):  # what is not zero is far away
        return normal.copy(), slopes, sizes
    more = _crosses(heights, moves) if found.value == 0.0 else np.zeros((0, 3))
    facets = weakest_facets(heights, found.value, found.direction, more)
    if not len(facets):
        return normal.copy(), slopes, sizes
    asked = heights.asked(facets)
    slopes[:] = np.inf
    for facet, extent in zip(facets, asked, strict=True):
        rates = moves @ facet
        rates[np.abs(rates) <= ROUNDING * sizes] = 0.0
        least, greatest = shares_at(heights, facet, found.value).T
        slopes = np.minimum(slopes, np.where(rates > 0.0, greatest, least) * rates / extent)
    if found.value == 0.0:
        slopes = np.maximum(slopes, 0.0)
    return facets, slopes + 0.0, sizes / asked.min()


def _is_hopeless(heights: Heights, found: Quality) -> bool:
    """Tell whether no small change gives a quality: some direction opposes all robots clearly."""
    if found.value > 0.0 or not found.criterion.is_nominal:
        return False
    return opposition(heights.generators, np.ones(len(heights.sizes))) > 0.0


def _crosses(heights: Heights, moves: Array) -> Array:
    """Return the normals (m, 3) across a robot's generator and the way it moves.

    At quality 0 the facets that a move makes may be there.
    """
    crosses = np.cross(heights.generators, moves[:2].reshape(4, -1, 3)).reshape(-1, 3)
    lengths = np.linalg.norm(crosses, axis=1)
    made = crosses[lengths > 0.0] / lengths[lengths > 0.0, None]
    return np.concatenate([made, -made])
