"""How numbers are written on a picture: in the units, the frame and the words it is drawn in."""

import math

from swarmgrasp.environment import KNOT
from swarmgrasp.plot import style
from swarmgrasp.quality import Criterion
from swarmgrasp.quality.criterion import NOMINAL, Load
from swarmgrasp.swarm import Swarm
from swarmgrasp.telling import Telling
from swarmgrasp.units import LENGTHS, SPEEDS
from swarmgrasp.words import WAYS, Unit

LEAST_PART = 5e-4
"""Share of a load below which a part of it goes unmentioned."""


def telling(*forces: float) -> Telling:
    """Return how the present picture is told, if it tells forces of some sizes [N]."""
    return Telling.of(style.terms(), 1.0, forces)


def unit_of(*sizes: float, criterion: Criterion = NOMINAL) -> Unit:
    """Return the unit for forces or qualities of some sizes [N]; with a task qualities have none.

    Examples
    --------
    >>> from swarmgrasp.quality import Polytope
    >>> from swarmgrasp.terms import Terms
    >>> unit_of(12_000.0).name, unit_of(0.39).name, unit_of(2e-3).name, unit_of(0.0).name
    ('kN', 'N', 'mN', 'N')
    >>> unit_of(1.2, criterion=Criterion(task=Polytope([(1e3, 0, 0)]))).name
    'times the task'
    >>> with style.settings(terms=Terms(force="tf")):
    ...     unit_of(12_000.0).name
    'tf'
    """
    return telling(*sizes).force if criterion.task is None else criterion.unit(*sizes)


def number(value: float) -> str:
    """Write a number with three digits that matter, and never as -0 or 1e+02.

    Examples
    --------
    >>> [number(v) for v in (0.0, -1e-18, 0.39214, 7.0, 1234.5, 2.5e-7)]
    ['0', '0', '0.392', '7', '1234', '2.5e-07']
    """
    if abs(value) < 1e-12:
        return "0"
    return f"{value:.0f}" if abs(value) >= 100.0 else f"{value:.3g}"


def force(value: float) -> str:
    """Write a force [N] with its unit.

    Examples
    --------
    >>> force(250.0), force(2.5e4)
    ('250 N', '25 kN')
    """
    unit = unit_of(value)
    return f"{number(value / unit.newtons)} {unit.name}"


def length(value: float) -> str:
    """Write a length [m] with its unit.

    Examples
    --------
    >>> from swarmgrasp.terms import Terms
    >>> with style.settings(terms=Terms("ft")):
    ...     length(3.048)
    '10 ft'
    """
    name = style.terms().length
    return f"{number(value / LENGTHS[name])} {name}"


def speed(value: float) -> str:
    """Write a speed [m/s] in knots, and beside them in the file's unit if that is another.

    Examples
    --------
    >>> speed(10.0)
    '19.4 kn (10 m/s)'
    """
    knots = f"{number(value / KNOT)} kn"
    if style.terms().speed == "kn":
        return knots
    size, name = other_speed()
    return f"{knots} ({number(value / size)} {name})"


def other_speed() -> tuple[float, str]:
    """Return size [m/s] and name of the unit of speeds beside knots: the file's, or m/s."""
    name = style.terms().speed
    name = "m/s" if name == "kn" else name
    return SPEEDS[name], name


def from_words(bearing: float) -> str:
    """Say where wind, current or sea come from by a bearing [rad], clockwise from the bow.

    Examples
    --------
    >>> from_words(0.5 * math.pi)
    'from 90°'
    """
    return telling().from_words(bearing).replace(" deg", "°")


def quality(value: float, criterion: Criterion = NOMINAL, reference: float | None = None) -> str:
    """Write a quality: a force, or with a task how many times that.

    Parameters
    ----------
    value : float [N]
    criterion : Criterion
    reference : float [N], optional
        Its size chooses the unit, instead of the quality's own.

    Examples
    --------
    >>> from swarmgrasp.quality import Polytope
    >>> quality(250.0, reference=4e4), quality(1.2, Criterion(task=Polytope([(1e3, 0, 0)])))
    ('0.25 kN', '1.2 times the task')
    """
    unit = unit_of(value if reference is None else reference, criterion=criterion)
    return f"{number(value / unit.newtons)} {unit.name}"


def gain(before: float, after: float, criterion: Criterion = NOMINAL) -> str:
    """Write how a quality changes, with the same decimals before and after.

    Parameters
    ----------
    before, after : float [N]
        With a task, without a unit.
    criterion : Criterion

    Examples
    --------
    >>> gain(0.0, 2100.0), gain(0.696, 0.696)
    ('quality 0 → 2.10 kN', 'quality stays 0.696 N')
    >>> gain(134_648.0, 311_200.0), gain(134_648.0, 135_268.0)
    ('quality 135 → 311 kN', 'quality 134.65 → 135.27 kN')
    >>> from swarmgrasp.quality import Polytope
    >>> gain(0.81, 1.24, Criterion(task=Polytope([(1e3, 0, 0)])))
    'quality 0.810 → 1.240 times the task'
    """
    unit = unit_of(max(before, after), criterion=criterion)
    old, new = before / unit.newtons, after / unit.newtons
    if abs(after - before) <= 1e-9 * max(before, after):
        return f"quality stays {number(new)} {unit.name}"
    least = _decimals(max(old, new), 3)
    decimals = max(least, _decimals(abs(new - old), 2))  # two digits of the gain show
    if old > 0.0:
        decimals = max(decimals, min(_decimals(old, 3), least + 2))
    first = f"{old:.{decimals}f}" if old > 0.0 else "0"
    return f"quality {first} → {new:.{decimals}f} {unit.name}"


def _decimals(value: float, digits: int) -> int:
    """Return the decimals that show so many significant digits of a positive value."""
    return max(0, digits - 1 - math.floor(math.log10(value)))


def load_sentence(load: Load, swarm: Swarm) -> str:
    """Write a steady wrench on the object [N, N, N m], by the ways it goes in every frame.

    Examples
    --------
    >>> from swarmgrasp import Outline
    >>> barge = Swarm(Outline([(-38, -11), (38, -11), (38, 11), (-38, 11)]), [])
    >>> load_sentence((0.0, -20e3, 1.5e6), barge)
    'Load on the object: 20 kN to starboard, 1500 kN m turning to port.'
    """
    x, y, turn = load
    arm = swarm.characteristic_length
    size = math.hypot(x, y, turn / arm)
    tell = telling(x, y, turn / arm)
    unit, metres = tell.force, tell.length.metres
    parts = [
        f"{number(abs(part) / unit.newtons)} {unit.name} {ways[part < 0.0]}"
        for part, ways in zip((x, y), WAYS, strict=True)
        if abs(part) > LEAST_PART * size
    ]
    if abs(turn) > LEAST_PART * size * arm:
        told = number(abs(turn) / unit.newtons / metres)
        parts.append(f"{told} {unit.torque} turning {WAYS[1][turn < 0.0]}")
    return f"Load on the object: {', '.join(parts)}."


def metric(swarm: Swarm) -> str:
    """Write by what metric wrenches are compared."""
    a1, a2 = swarm.force_weights
    name = style.terms().length
    arm = swarm.characteristic_length / LENGTHS[name]
    return f"force weights {a1:g} and {a2:g}, characteristic length {arm:.6g} {name}"


def frame_sentences() -> list[str]:
    """Say how the coordinates of the picture run, where they are not as usual.

    Examples
    --------
    >>> from swarmgrasp.terms import Frame, Terms
    >>> frame_sentences()
    []
    >>> with style.settings(terms=Terms(frame=Frame(mirrored=True))):
    ...     frame_sentences()
    ['Frame: x forward, y to starboard.']
    """
    frame = style.terms().frame
    if not frame.mirrored and frame.bow == 0.0:
        return []
    return [f"Frame: {telling().frame_words}."]


def count(robots: int) -> str:
    """Write a number of robots.

    Examples
    --------
    >>> [count(n) for n in (0, 1, 2)]
    ['no robots', '1 robot', '2 robots']
    """
    terms = style.terms()
    return terms.robots(robots) if robots else f"no {terms.several}"
