"""Why a quality is what it is, in plain sentences."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.heights import ON_FACET
from swarmgrasp.swarm.sectors import sector_words
from swarmgrasp.words import Unit, degrees, list_words, percent, wrench_words

if TYPE_CHECKING:
    from swarmgrasp.quality.max_transfer import Quality
    from swarmgrasp.swarm import Swarm

MOST_NAMED = 6
"""Robots up to which they are named, and not counted."""
FIGURES = 4
"""Significant digits in a sentence."""
EQUAL = 1e-9
"""Relative difference of two heights that are equal."""


def explain_quality(found: "Quality", swarm: "Swarm") -> str:
    """Say what a swarm can do, what limits it, who sets that, and how far it is from the best.

    Parameters
    ----------
    found : Quality
    swarm : Swarm
        That it is of.

    Returns
    -------
    str
        A sentence per line.

    Examples
    --------
    >>> from swarmgrasp.quality.max_transfer import quality
    >>> from swarmgrasp.scenario import load_example
    >>> swarm = load_example("model-ship").swarm
    >>> for sentence in explain_quality(quality(swarm), swarm).splitlines()[2:4]:
    ...     print(sentence)
    R3 and R5 set this limit: they span the weakest facet.
    There R2 works at full force and R1 and R4 add nothing.
    """
    if not len(swarm):
        return "There are no robots."
    unit = found.criterion.unit(found.value or found.noise, figures=FIGURES)
    return "\n".join(
        [
            *_headline(found, swarm, unit),
            *limit_sentences(found, swarm, unit),
            *_work_sentences(found, swarm),
            *loss_sentences(found),
            *_opposite_sentences(found, swarm),
            *_bound_sentences(found, unit),
        ]
    )


def crew_words(names: Sequence[str]) -> str:
    """Name robots, or count them if they are many."""
    return f"{len(names)} robots" if len(names) > MOST_NAMED else list_words(names)


def limit_sentences(found: "Quality", swarm: "Swarm", unit: Unit, now: str = "") -> list[str]:
    """Say which direction is weakest, how large the wrench there is, and who sets it.

    Parameters
    ----------
    found : Quality
    swarm : Swarm
        That it is of.
    unit : Unit
        Of the quality.
    now : str
        Follows the verb, such as " now".
    """
    way = f"The swarm is{now} weakest at {found.weakest_words}"
    if found.value == 0.0:
        is_missed = found.criterion.task is None and found.margin < 0.0
        said = [f"{way}: that way it {'falls short most' if is_missed else 'exerts nothing'}."]
    else:
        if found.criterion.task is not None:
            size = float(np.linalg.norm(found.weakest_wrench * swarm.scale))
            unit = Unit.for_size(size, figures=FIGURES)
        x, y, turn = unit.wrench(found.weakest_wrench.tolist(), swarm.characteristic_length)
        said = [
            f"{way}: there it exerts at most {x} along x, {y} along y and {turn} of torque at once."
        ]
    gone = set(found.gone)
    setters = [name for name in found.facet_robots if name not in gone]
    if len(setters) > 1 and swarm.has_rays_only:
        said.append(f"{crew_words(setters)} set this limit: they span the weakest facet.")
    elif setters and not swarm.has_rays_only:
        verb = "sets" if len(setters) == 1 else "set"
        said.append(f"{crew_words(setters)} {verb} this limit, where the best force jumps.")
    return said


def loss_sentences(found: "Quality") -> list[str]:
    """Say which failure and whose loss are worst."""
    said = []
    if len(found.criterion.failures) > 1:
        said.append(f"The worst failure is that of {crew_words(found.failure)}.")
    if found.lost:
        said.append(f"The worst loss is that of {crew_words(found.lost)}.")
    return said


def _headline(found: "Quality", swarm: "Swarm", unit: Unit) -> list[str]:
    """Say what the swarm can do in every direction."""
    words = found.criterion.words(swarm)
    given = f"{words[0].upper()}{words[1:]}, the swarm" if words else "The swarm"
    if found.choice is not None:
        return _choice_sentences(found, given)
    if 0.0 < found.value <= found.noise:
        return [
            f"{given} has {unit.text(found.value)}, and that may be rounding: the decimals of the "
            f"outline's coordinates tell it to {unit.text(found.noise)} only."
        ]
    if found.value > 0.0:
        value = unit.text(found.value)
        if found.criterion.task is not None:
            return [f"{given} manages {value}."]
        return [f"{given} exerts at least {value} in every direction, turning included."]
    if found.criterion.task is None and found.margin < 0.0:
        short = Unit.for_size(found.margin, figures=FIGURES).text(-found.margin)
        drift = wrench_words(-found.missing * swarm.scale)
        return [f"{given} is {short} short of holding the load, which leaves the object {drift}."]
    if found.is_force_closure:
        return [f"{given} has nothing to spare beside the load."]
    if str(found.force_closure) == "marginal":
        return [f"{given} is on the border of force closure: the outline's rounding decides."]
    return [f"{given} has no force closure: in some directions it exerts nothing."]


def _choice_sentences(found: "Quality", given: str) -> list[str]:
    """Say what robots do that change between sectors with gaps, and which ones it is best to keep.

    What follows is of a swarm that keeps them.
    """
    unit = found.criterion.unit(found.upper_bound or found.noise, figures=FIGURES)
    choice = found.choice
    assert choice is not None
    kept = [f"{name} in {sector_words(each)}" for name, each in choice.sectors.items()]
    if len(kept) > MOST_NAMED:
        kept = [f"{len(kept)} robots in one sector each"]
    best = "the best choice" if choice.is_best else "the best choice that was found"
    least, most = unit.text(found.bound), unit.text(found.upper_bound)
    if found.upper_bound == 0.0:
        said = f"{given} exerts nothing in some directions, whatever sectors robots push in."
    else:
        said = f"{given} has from {least} to {most}, as robots may change between sectors."
    return [said, f"Keeping {list_words(kept)}, {best}, it has {unit.text(found.value)}."]


def _work_sentences(found: "Quality", swarm: "Swarm") -> list[str]:
    """Say who works and who does not when the swarm makes the weakest wrench."""
    if found.value == 0.0 or found.criterion.worst_case:
        return []
    gone = np.zeros(len(swarm), dtype=bool)
    gone[[swarm.index(name) for name in found.gone]] = True
    if not swarm.has_rays_only:
        return _steering_sentences(found, swarm, gone)
    generators = swarm.scaled_generators
    products = generators @ found.direction
    rounding = ON_FACET * np.linalg.norm(generators, axis=1)
    parts = []
    for chosen, does in ((products > rounding, "at full force"), (products < -rounding, "nothing")):
        indices = np.flatnonzero(chosen & ~gone).tolist()
        if indices:
            parts.append(
                f"{crew_words([swarm.names[i] for i in indices])} {_works(len(indices), does)}"
            )
    return [f"There {list_words(parts)}."] if parts else []


def _steering_sentences(found: "Quality", swarm: "Swarm", gone: NDArray[np.bool_]) -> list[str]:
    """Say how each robot pushes when the swarm makes the weakest wrench, if they are few."""
    there = np.flatnonzero(~gone).tolist()
    if len(there) > MOST_NAMED:
        return []
    wrenches = Aim(swarm, found.criterion).worst_wrenches(tuple(found.direction.tolist()))
    forces = wrenches[:, :2] / swarm.scale[:2]
    does: dict[str, list[str]] = {}
    for i in there:
        does.setdefault(_steers(swarm, i, forces[i]), []).append(swarm.names[i])
    parts = [f"{list_words(names)} {_plural(verb, len(names))}" for verb, names in does.items()]
    return [f"There {list_words(parts)}."] if parts else []


def _steers(swarm: "Swarm", i: int, force: NDArray[np.float64]) -> str:
    """Say what a robot does that exerts a force (2,) [N]."""
    size, steers = float(np.hypot(*force)), float(swarm.steers[i])
    if size <= ON_FACET * float(swarm.limits[i]):
        return "adds nothing"
    way = math.atan2(force[1], force[0])
    off = math.remainder(way - float(swarm.directions[i]), math.tau)
    if 0.0 < steers < math.pi and abs(abs(off) - steers) <= ON_FACET:
        return f"steers to its {'port' if off > 0.0 else 'starboard'} limit"
    if steers == 0.0 and abs(off) <= ON_FACET and not swarm.leasts[i]:
        return "works at full force"
    if steers == 0.0 and abs(abs(off) - math.pi) <= ON_FACET:
        return "works astern"
    return f"pushes at {degrees(way)} deg"


def _plural(verb: str, count: int) -> str:
    """Return what one robot does, or the same of several."""
    first, _, rest = verb.partition(" ")
    stem = "push" if first == "pushes" else first.removesuffix("s")
    return verb if count == 1 else f"{stem} {rest}".replace(" its ", " their ")


def _works(count: int, does: str) -> str:
    """Say what one robot or several do."""
    if does == "nothing":
        return "adds nothing" if count == 1 else "add nothing"
    return f"{'works' if count == 1 else 'work'} {does}"


def _opposite_sentences(found: "Quality", swarm: "Swarm") -> list[str]:
    """Say so if the opposite direction is as weak: no single robot helps then (T17)."""
    if found.value == 0.0 or found.choice is not None:
        return []
    (opposite,) = Aim(swarm, found.criterion).values(-found.direction[None])
    if opposite > found.value * (1.0 + EQUAL):
        return []
    return [
        "The opposite way is as weak, so that no single newcomer that pushes one way can help: "
        "place two, or one that reverses."
    ]


def _bound_sentences(found: "Quality", unit: Unit) -> list[str]:
    """Say how near the quality is to what is proven."""
    said = []
    if found.choice is None and unit.text(found.bound) != unit.text(found.value):
        said.append(f"It is proven to be {unit.text(found.bound)} or more.")
    if found.value > 0.0 and found.criterion.is_nominal:
        share, ceiling = percent(found.efficiency), unit.text(found.ceiling)
        said.append(
            f"The quality is {share} of {ceiling}, which robots with these limits could not exceed "
            "wherever they were."
        )
    return said
