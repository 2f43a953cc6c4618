"""`swarmgrasp capability`: the weather the robots hold, at every bearing."""

import re
from collections.abc import Callable
from contextlib import AbstractContextManager
from math import degrees, radians
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from cyclopts import Parameter

from swarmgrasp.cli.amounts import Amount
from swarmgrasp.cli.criteria import criterion_of
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import (
    blaming,
    json_faults,
    read_scenario,
)
from swarmgrasp.cli.progress import shown_progress
from swarmgrasp.cli.question import asked_before, check_newcomer
from swarmgrasp.cli.streams import speed_given
from swarmgrasp.cli.weather import STILL, Water
from swarmgrasp.cli.wording import FILE, Wording

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from swarmgrasp.environment import Environment
    from swarmgrasp.plain import Answer
    from swarmgrasp.quality import Criterion
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.terms import Terms

WINDS, NUMBERS, USE, JOINED = (
    "capability", "capability numbers", "thrust use", "capability with newcomer"
)  # fmt: skip
"""What may be asked, as answers call it."""


def capability(
    file: Dashed,
    /,
    *,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    failures: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    numbers: Annotated[bool, Parameter(negative="")] = False,
    use: Annotated[str | None, Parameter(metavar="SPEED")] = None,
    with_newcomer: Annotated[bool, Parameter(negative="")] = False,
    step: Annotated[str | None, Parameter(metavar="ANGLE")] = None,
    plot: Path | None = None,
    drawing: Drawing = USUAL,
    json: Dashed | None = None,
    water: Water = STILL,
    wording: Wording = FILE,
) -> None:
    """Tell the largest wind the robots hold from every bearing, intact and after a loss.

    Needs the scenario's environment: what the object shows to wind and current. The current
    comes from where the wind comes, unless the scenario says otherwise; so do the waves, if it
    has any. Loads are steady.

    Example: swarmgrasp capability supply-vessel --plot capability.png

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        supply-vessel. Its newcomer is left out. Or an answer of this command, whose options hold
        unless given anew.
    losing
        How many robots, or groups, are lost, the worst ones at each bearing; at least 1, the
        default without failures.
    failures
        After the worst of these failures, before any loss: a robot or a group by name, or several
        that fail together, with commas. Give it once for each: --failures "bus A" --failures
        Ajax,Boreas. Instead of those in the file. No robot is lost besides unless --losing says so.
    worst_case
        In the worst poses that the robots' tolerances allow.
    numbers
        Instead of winds the largest step held of those by which DNV-ST-0111 numbers capabilities:
        wind, sea and current from one bearing. It is no assessment by that standard.
    use
        Instead the part of its limit that each robot uses in a wind of this speed, such as 25kn,
        from every bearing, with all of them.
    with_newcomer
        Also with the newcomer, in the place that `swarmgrasp place` finds: before and after.
    step
        Between the bearings, 1 to 90 degrees; 5 unless given.
    plot
        Draw the answer to this .png, .svg or .pdf file: a polar diagram with the bow up, or
        the robots' shares over the bearings.
    json
        Also write the numbers to this .json file; "-" prints them and nothing else.
        SI units and radians.
    """
    faults = _option_faults(losing, step, use, numbers=numbers, with_newcomer=with_newcomer)
    given = {"--losing": losing, "--failures": failures, "--worst-case": worst_case}
    if use is not None:
        idle = [option for option, value in given.items() if value]
        faults += [f"--use is of all robots as they stand; leave out {option}" for option in idle]
    faults += json_faults(json) + wording.faults(json) + water.faults()
    scenario = read_scenario(file, faults + drawing.faults(plot))
    before = asked_before(scenario, WINDS, NUMBERS, USE, JOINED)
    what = _form(scenario, use, numbers=numbers, with_newcomer=with_newcomer)
    terms = wording.terms(scenario)
    environment = water.environment(scenario, file, terms, "`swarmgrasp capability`")
    if what == JOINED:
        check_newcomer(scenario, file, "capability --with-newcomer")
    criterion = criterion_of(scenario, file, losing, worst_case, failures)
    import numpy as np

    bearings = before.get("bearings") if step is None else None
    if bearings is None:
        apart = None if step is None else _step(step).value(terms)
        bearings = bearings_apart(apart, scenario.terms.frame.heading)
    speed = before.get("speed", 0.0) if use is None else speed_given("--use", use).value(terms)
    look = drawing.look(scenario.name, terms)
    asked = _Asked(scenario, file, environment, criterion, np.array(bearings), look)
    with blaming(file):
        found = _use(asked, speed) if what == USE else ASK[what](asked)
    _deliver(asked, found, plot, json, wording)


def _step(text: str) -> Amount:
    """Return the angle between bearings."""
    return Amount("--step", text, "angle", radians(1.0 - 1e-9), radians(90.0 + 1e-9))


def bearings_apart(
    step: float | None = None, heading: float | None = None
) -> "NDArray[np.float64]":
    """Return bearings (m,) [rad], clockwise from the bow, from all round.

    Parameters
    ----------
    step : float, optional [rad]
        Between them; the usual one when left out.
    heading : float, optional [rad]
        The true bearing of the bow: the true bearings are round numbers then.
    """
    import numpy as np

    from swarmgrasp.capability.asked import APART

    apart, off = degrees(step or APART), degrees(heading or 0.0)
    return np.asarray(np.radians((np.arange(0.0, 360.0 - 1e-9, apart) - off) % 360.0))


class _Asked(NamedTuple):
    """A question from the command line."""

    scenario: "Scenario"
    file: str
    environment: "Environment"
    criterion: "Criterion"
    bearings: "NDArray[np.float64]"
    look: dict[str, Any]

    @property
    def arguments(self) -> "tuple[Any, Any, Any, int, bool, Any]":
        """What functions of capability take; one robot is lost unless something else is said."""
        criterion = self.criterion
        losing = criterion.losing or int(not criterion.failures)
        return (
            self.scenario.swarm, self.environment, self.bearings, losing, criterion.worst_case,
            criterion.failures,
        )  # fmt: skip

    def bar(self) -> "AbstractContextManager[Callable[[int], None] | None]":
        """Return a context with a bar for the winds found, one each for all and after losses."""
        return shown_progress(2 * len(self.bearings), "looking at winds")


class _Found(NamedTuple):
    """An answer, and how it is told and drawn."""

    answer: "Answer"
    show: "Callable[[Terms], None]"
    draw: "Callable[[Path], Path]"


def _winds(asked: _Asked) -> _Found:
    """Find the largest winds held."""
    from swarmgrasp.capability import capability as capability_of
    from swarmgrasp.cli.show.capability import show

    with asked.bar() as bar:
        found = capability_of(*asked.arguments, progress=bar)
    name = asked.scenario.name

    def draw(path: Path) -> Path:
        """Draw the diagram."""
        from swarmgrasp.plot import capability_diagram, save

        return save(capability_diagram(found, **asked.look), path)

    return _Found(found, lambda terms: show(name, found, terms), draw)


def _numbers(asked: _Asked) -> _Found:
    """Find the largest steps held."""
    from swarmgrasp.capability import capability_numbers
    from swarmgrasp.cli.show.capability_numbers import show

    with asked.bar() as bar:
        found = capability_numbers(*asked.arguments, progress=bar)
    name = asked.scenario.name

    def draw(path: Path) -> Path:
        """Draw the diagram."""
        from swarmgrasp.plot import numbers_diagram, save

        return save(numbers_diagram(found, **asked.look), path)

    return _Found(found, lambda terms: show(name, found, terms), draw)


def _use(asked: _Asked, speed: float) -> _Found:
    """Find which part of their limits the robots use."""
    from swarmgrasp.capability import thrust_use
    from swarmgrasp.cli.show.thrust_use import show

    found = thrust_use(asked.scenario.swarm, asked.environment, speed, asked.bearings)
    name = asked.scenario.name

    def draw(path: Path) -> Path:
        """Draw the shares."""
        from swarmgrasp.plot import save, thrust_use_picture

        return save(thrust_use_picture(found, **asked.look), path)

    return _Found(found, lambda terms: show(name, found, terms), draw)


def _joined(asked: _Asked) -> _Found:
    """Find the largest winds held before and after the newcomer joins."""
    from swarmgrasp.capability import capability as capability_of
    from swarmgrasp.capability import capability_joined
    from swarmgrasp.cli.place import solve
    from swarmgrasp.cli.show.capability_joined import show

    (placement,) = solve(asked.scenario, asked.file, criterion=asked.scenario.criterion)
    with asked.bar() as bar:
        before = capability_of(*asked.arguments, progress=bar)
    with asked.bar() as bar:
        found = capability_joined(placement, asked.environment, before, progress=bar)
    name = asked.scenario.name

    def draw(path: Path) -> Path:
        """Draw both."""
        from swarmgrasp.plot import capability_diagram, save

        figure = capability_diagram(found.after, before=found.before, **asked.look)
        return save(figure, path)

    return _Found(found, lambda terms: show(name, found, terms), draw)


ASK = {WINDS: _winds, NUMBERS: _numbers, JOINED: _joined}
"""What finds an answer, by what is asked."""


def _deliver(
    asked: _Asked, found: _Found, plot: Path | None, json: str | None, wording: Wording
) -> None:
    """Hand over an answer."""
    from swarmgrasp.answer_file import document_of

    def draw() -> list[Path]:
        """Draw if that is wanted."""
        return [] if plot is None else [found.draw(plot)]

    scenario = asked.scenario
    document = document_of(found.answer, scenario.name, terms=scenario.terms)
    terms = wording.terms(scenario)
    deliver(json, document, lambda: found.show(terms), draw, csv=wording.csv)


def _form(scenario: "Scenario", use: str | None, *, numbers: bool, with_newcomer: bool) -> str:
    """Return what is asked: by an option, or by the answer that is asked again."""
    if use is not None:
        return USE
    if numbers:
        return NUMBERS
    if with_newcomer:
        return JOINED
    return next((kind for kind in (NUMBERS, USE, JOINED) if asked_before(scenario, kind)), WINDS)


def _option_faults(
    losing: str | None, step: str | None, use: str | None, *, numbers: bool, with_newcomer: bool
) -> list[str]:
    """Return what is wrong with the options."""
    faults = []
    # int() would also take 1_0, and cyclopts 1.5 and 0x2
    if losing is not None and not re.fullmatch(r"0*[1-9][0-9]{0,5}", losing):
        faults.append(f"--losing is {losing}; it should be a whole number, at least 1")
    faults += [] if step is None else _step(step).faults()
    forms = {"--numbers": numbers, "--use": use is not None, "--with-newcomer": with_newcomer}
    given = [option for option, is_given in forms.items() if is_given]
    if len(given) > 1:
        faults.append(f"{' and '.join(given)} each ask something else; keep one")
    return faults + ([] if use is None else speed_given("--use", use).faults())
