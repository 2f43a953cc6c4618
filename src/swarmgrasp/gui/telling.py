"""The answer in words, as one says it on a bridge: the verdict, the order, figures and facts."""

import math
from collections.abc import Callable

from swarmgrasp.gui.asking import Found
from swarmgrasp.gui.figures import DEGREE, SPACE, Figures, count
from swarmgrasp.gui.replies import First
from swarmgrasp.gui.told_parts import AnswerPart, Fact, Figure, NextPlace, Order, WeakestTold
from swarmgrasp.outline import Outline
from swarmgrasp.quality import Quality
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.words import list_words, turned

MOST_MARKED = 300
"""Names that views mark."""
MOST_NAMED = 3
"""Robots named in a fact."""
MOST_NEXT = 3
"""Other places told."""
FINE = 1e-6
"""Relative gap below which it is told as 0.0001 %."""
SQUARE = 0.5
"""Degrees off the normal that count as none."""


class Telling:
    """Tells what was found."""

    def __init__(self, found: Found) -> None:
        self.found = found
        self.figures = Figures(found.question.terms)

    def part(self, n: int, ms: float) -> AnswerPart:
        """Return the whole answer."""
        found, after = self.found, self.found.after
        before, value, bound = found.values
        robot = found.newcomer
        x, y, turn = found.problem.criterion.load
        gone = self._gone(after)
        return AnswerPart(
            n=n,
            ms=ms,
            question=found.about,
            first=self.first(),
            second=self.second(),
            order=self.order(),
            figures=self.told(),
            facts=self.facts(),
            next=self.next_best(),
            newcomer=None if robot is None else robot.to_data(),
            before=before,
            after=value,
            bound=bound,
            margin=after.margin,
            load=(x, y, turn),
            weakest=self._weakest(after),
            worst_loss=gone or None,
            share=None if math.isnan(after.efficiency) else after.efficiency,
        )

    # -- the verdict -----------------------------------------------------------------------

    def first(self) -> First:
        """Return the first line."""
        found, after = self.found, self.found.after
        good, criterion = after.value > 0.0, self.found.problem.criterion
        if found.question.in_weather:
            return First(f"{'Held' if good else 'Not held'} in {self._wind()}", good)
        if criterion.has_load:
            return First("Holds the load" if good else "Does not hold the load", good)
        if not good:
            return First("Does not hold every way", False)
        if criterion.task is not None:
            return First(f"Does {self._value(after.value)} times what is asked", True)
        return First(f"Holds {self.figures.forces(after.value)} every way", True)

    def second(self) -> str:
        """Return its sentence: after what losses, and what else is held."""
        found, after = self.found, self._after_words()
        is_of_worst = found.problem.criterion.is_of_worst
        if found.about == "wind":
            return f"at most {self.figures.speeds(found.values[1])} from there, {after}"
        if found.about == "load":
            return f"at most {round(100.0 * found.values[1])}{SPACE}% of the load, {after}"
        if self._is_missed:
            return f"short by {self.figures.forces(-found.after.margin)}, {after}"
        if not found.after.value:
            return after
        if found.newcomer is not None and found.before == 0.0:
            once = f"only once {found.newcomer.name} is in place"
            return f"{once}, then also {after}" if is_of_worst else f"{once}, {after}"
        return f"also {after}" if is_of_worst else after

    @property
    def _is_missed(self) -> bool:
        """Whether a load is missed, and nothing else was found to be told instead."""
        found, criterion = self.found, self.found.problem.criterion
        is_plain = criterion.task is None and found.about == "quality"
        return is_plain and criterion.has_load and found.after.margin < 0.0

    def _after_words(self) -> str:
        """Say with whom, or after what."""
        swarm, criterion = self.found.swarm, self.found.problem.criterion
        gone, failures = [], criterion.failures
        if len(failures) == 1:
            gone.append(f"the failure of {list_words(failures[0])}")
        elif failures:
            gone.append(f"the worst of {count(len(failures))} failures")
        if criterion.losing:
            gone.append(f"losing {self._lost(swarm)}")
        said = [f"after {list_words(gone)}"] if gone else []
        if criterion.worst_case:
            said.append("in the worst poses")
        return ", ".join(said) or f"with {_all_of(len(swarm))} working"

    def _lost(self, swarm: Swarm) -> str:
        """Say how many of how many are lost."""
        losing, machines = self.found.problem.criterion.losing, len(set(swarm.machines.tolist()))
        if losing >= machines:
            return "all of them"
        if swarm.rare.groups:
            return f"any {count(losing)} of the {self.found.question.terms.several} or groups"
        return f"any {count(losing)} of the {count(machines)}"

    def _wind(self) -> str:
        """Say which wind it is."""
        environment = self.found.question.environment
        assert environment is not None
        speed, bearing = environment.wind.speed or 0.0, environment.wind.bearing or 0.0
        return f"{self.figures.speeds(speed)} from {self.figures.coming(bearing)}"

    # -- the order -------------------------------------------------------------------------

    def order(self) -> Order | None:
        """Return who goes where, and does what."""
        placement = self.found.placement
        if placement is None:
            return None
        robot = placement.robot
        return Order(
            robot.name,
            placement.place,
            robot.contact,
            robot.direction,
            do_words(robot, self.found.problem.swarm.outline, self.figures),
        )

    # -- figures and facts -----------------------------------------------------------------

    def told(self) -> tuple[Figure, ...]:
        """Return the large figures."""
        found = self.found
        before, after, _ = found.values
        numbers = (None if found.placement is None else before), after
        name = found.newcomer.name if found.newcomer is not None else ""
        figures, criterion = self.figures, found.problem.criterion
        if found.about == "wind":
            words = f"most wind from {self._from()}, with {name} there"
            return (_figure(*numbers, figures.in_speed, figures.terms.speed, words),)
        if found.about == "load":
            return (_figure(*numbers, float, "times", "the load is held"),)
        if self._is_missed:
            short = figures.in_force(-found.after.margin)
            return (Figure(None, short, figures.force_unit, "missing in the worst case"),)
        words = "in the weakest direction"
        if criterion.has_load:
            words = f"to spare {words}"
        if criterion.task is not None:
            return (_figure(*numbers, float, "times", words),)
        return (_figure(*numbers, figures.in_force, figures.force_unit, words),)

    def facts(self) -> tuple[Fact, ...]:
        """Return what is proven, what is weakest, and whose loss is worst."""
        found, after = self.found, self.found.after
        told = [] if found.placement is None else [Fact("proven", "Proven", self._proven(), ())]
        if found.nowhere:
            told.append(Fact("note", "No place", found.nowhere, ()))
        names = _few(after.facet_robots) if after.value > 0.0 else ()
        set_by = f", set by {list_words(names)}" if 0 < len(names) <= MOST_NAMED else ""
        if len(found.swarm):
            told.append(Fact("weakest", "Weakest", after.weakest_words + set_by, names))
        gone = self._gone(after)
        if gone:
            told.append(Fact("loss", "Worst loss", list_words(gone), gone))
        return tuple(told)

    def _proven(self) -> str:
        """Say how far from the best the answer can be."""
        found = self.found
        _, after, bound = found.values
        assert bound is not None
        if found.about == "wind":
            return "no allowed place holds this wind; none holds more than here"
        if found.about == "load":
            return "no allowed place holds the load; none holds more of it than here"
        if after == 0.0:
            held = "it" if found.problem.criterion.has_load else "every way"
            return f"no allowed place holds {held}"
        return f"within {100.0 * max(bound / after - 1.0, FINE):.1g}{SPACE}% of the best"

    def next_best(self) -> tuple[NextPlace, ...]:
        """Return the best of other places."""
        found = self.found
        if found.placement is None:
            return ()
        best = found.placement.quality or 1.0
        told = []
        for runner in found.placement.runners_up[:MOST_NEXT]:
            robot, value = runner.robot, runner.quality
            share = value / best
            if found.about == "wind":
                value, share = math.sqrt(value), math.sqrt(share)
            told.append(
                NextPlace(
                    runner.place, robot.contact, robot.direction, value, self._with_unit(value),
                    share,
                )
            )  # fmt: skip
        return tuple(told)

    # -- parts -----------------------------------------------------------------------------

    def _from(self) -> str:
        """Say where the wind comes from."""
        environment = self.found.question.environment
        assert environment is not None
        return self.figures.coming(environment.wind.bearing or 0.0)

    def _value(self, value: float) -> str:
        """Return what is best, without its unit."""
        if self.found.about == "wind":
            return self.figures.speed(value)
        if self.found.about == "load" or self.found.problem.criterion.task is not None:
            return f"{value:.2f}"
        return self.figures.force(value)

    def _with_unit(self, value: float) -> str:
        """Return what is best, with its unit."""
        told = self._value(value)
        if self.found.about == "wind":
            return f"{told}{SPACE}{self.figures.terms.speed}"
        if self.found.about == "load" or self.found.problem.criterion.task is not None:
            return f"{told} times"
        return f"{told}{SPACE}{self.figures.force_unit}"

    def _gone(self, after: Quality) -> tuple[str, ...]:
        """Return who fails and is lost in the worst case."""
        return (*after.failure, *after.lost)

    def _weakest(self, after: Quality) -> WeakestTold | None:
        """Return the weakest wrench; of none held, its direction."""
        if not len(self.found.swarm):
            return None
        wrench = after.weakest_wrench
        if after.value == 0.0:
            wrench = after.direction / self.found.swarm.scale
        x, y, turn = wrench.tolist()
        return WeakestTold((x, y, turn), _few(after.facet_robots))


def do_words(robot: Robot, outline: Outline, figures: Figures) -> str:
    """Say what a robot is to do."""
    limit = figures.forces(robot.limit)
    if robot.steers >= math.pi or robot.lever:
        return f"Push {limit} any way"
    towards = figures.bearing(robot.direction)
    if robot.mounted:
        return f"Push {limit} towards {towards}"
    normal = outline.at_point(robot.contact).inward
    off = turned(robot.direction - normal)
    verb = "Push"
    if abs(off) > 90.0:
        verb, normal = "Pull", normal + math.pi
        off = turned(robot.direction - normal)
    if robot.steers:
        half = round(math.degrees(robot.steers))
        return f"{verb} {limit} within {half}{DEGREE} of {towards}"
    return f"{verb} {limit} towards {towards}, {_lean(off, normal)}"


def _figure(
    before: float | None, after: float, told: Callable[[float], float], unit: str, words: str
) -> Figure:
    """Return a figure in a unit."""
    return Figure(None if before is None else told(before), told(after), unit, words)


def _few(names: tuple[str, ...]) -> tuple[str, ...]:
    """Return names that can be marked one by one; nobody where they are too many."""
    return names if len(names) <= MOST_MARKED else ()


def _all_of(number: int) -> str:
    """Say that all of so many do something."""
    return {0: "nobody", 1: "the only one", 2: "both"}.get(number, f"all {count(number)}")


def _lean(off: float, normal: float) -> str:
    """Say how a force leans off the normal [rad], by an angle [deg], counter-clockwise.

    Examples
    --------
    >>> _lean(7.0, -math.pi / 2), _lean(-20.0, math.pi), _lean(0.2, 0.0)
    ('7\u00b0 forward of square', '20\u00b0 to port of square', 'square')
    """
    if abs(off) < SQUARE:
        return "square"
    way = normal + math.copysign(math.pi / 2, off)
    x, y = math.cos(way), math.sin(way)
    along, across = ("forward", "aft")[x < 0.0], ("to port", "to starboard")[y < 0.0]
    side = along if abs(x) > abs(y) else across
    return f"{round(abs(off))}{DEGREE} {side} of square"
