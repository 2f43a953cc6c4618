"""Build the criterion of a scenario, and find the faults its schema does not see."""

from swarmgrasp.environment import Environment
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.outline import Outline
from swarmgrasp.quality import Criterion, Ellipsoid, Polytope
from swarmgrasp.ranges import nearest_name
from swarmgrasp.scenario.criterion_schema import CriterionSection, TaskSection
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.swarm.names import filled

_CRITERION: Path = ("criterion",)


def check_criterion(checked: Checked) -> None:
    """Note what is wrong with the criterion of a document, whatever its outline is."""
    section = checked.file.criterion
    if section is None:
        return
    if section.worst_case:
        _check_worst_case(checked)
    if section.load == "environment":
        _check_load(checked)
    _check_failures(section, checked)
    if section.task is not None:
        _check_task(section.task, (*_CRITERION, "task"), checked)


def criterion_of(
    checked: Checked, units: Units, outline: Outline, environment: Environment | None
) -> Criterion:
    """Return the criterion of a document without faults.

    Parameters
    ----------
    checked : Checked
    units : Units
    outline : Outline
    environment : Environment or None
        For the steady load of wind and current.

    Raises
    ------
    ScenarioInvalid
        If a number is too small to compute with.
    """
    section = checked.file.criterion
    if section is None:
        return Criterion()
    try:
        return Criterion(
            losing=section.losing,
            worst_case=section.worst_case,
            load=_load(section, units, outline, environment),
            task=None if section.task is None else _task(section.task, units),
            failures=_failures(section),
        )
    except SwarmGraspError as error:  # numbers next to zero only
        checked.fault(_CRITERION, "; ".join(error.faults), got=False)
        raise checked.faults.error() from error


# -- parts --------------------------------------------------------------------------------


def _load(
    section: CriterionSection, units: Units, outline: Outline, environment: Environment | None
) -> tuple[float, float, float]:
    """Return the steady load [N, N, N m]."""
    if isinstance(section.load, list):
        return units.wrench(section.load)
    if section.load is None or environment is None:
        return 0.0, 0.0, 0.0
    surge, sway, yaw = environment.load(outline).tolist()
    return surge, sway, yaw


def _failures(section: CriterionSection) -> tuple[tuple[str, ...], ...]:
    """Return the failures, each by the names of its robots and groups."""
    given = section.failures or []
    return tuple((each,) if isinstance(each, str) else tuple(each) for each in given)


def _task(section: TaskSection, units: Units) -> Polytope | Ellipsoid:
    """Return a task in SI units and our frame."""
    if section.polytope is not None:
        return Polytope([units.wrench(vertex) for vertex in section.polytope])
    return Ellipsoid([units.wrench(axis) for axis in section.ellipsoid or []])


def _check_worst_case(checked: Checked) -> None:
    """Note a worst case without tolerances, or with a newcomer that may not come."""
    file, here = checked.file, (*_CRITERION, "worst_case")
    holders: list[Path] = [(), ("newcomer",), *(("robots", i) for i in range(len(file.robots)))]
    is_sound = checked.is_known("robots") and checked.is_known("newcomer")
    if is_sound and not any(checked.has(*path, "tolerance") for path in holders):
        said = "asks for nothing, as no robot has a tolerance; give some"
        checked.fault(here, said)
    own = None if file.newcomer is None else file.newcomer.tolerance
    if own is not None and own.may_be_absent:
        said = "a newcomer that may be absent is worth nothing in the worst case"
        checked.fault(("newcomer", "tolerance", "may_be_absent"), said)


def _check_failures(section: CriterionSection, checked: Checked) -> None:
    """Note a failure of nobody: of a name that neither a robot nor a group has."""
    robots = checked.file.robots
    known = [*filled([robot.name for robot in robots]), *(robot.group for robot in robots)]
    known = list(dict.fromkeys(name for name in known if name))
    here: Path = (*_CRITERION, "failures")
    if not checked.is_sound("robots") or not checked.is_sound(*here):
        return
    for i, names in enumerate(_failures(section)):
        is_list = isinstance((section.failures or [])[i], list)
        for k, name in enumerate(names):
            if name not in known:
                near = nearest_name(name, known) if known else ""
                said = f"there is no robot or group of that name{near}"
                checked.fault((*here, i, k) if is_list else (*here, i), said)


def _check_load(checked: Checked) -> None:
    """Note an environment that has no steady load to give."""
    here = (*_CRITERION, "load")
    section = checked.file.environment
    if not checked.has("environment"):
        said = "needs an environment, its wind with speed and from"
        checked.fault(here, said)
    elif section is not None and not any(
        checked.has("environment", "wind", key) for key in ("speed", "from")
    ):
        said = "needs a steady wind: give environment.wind its speed and from"
        checked.fault(here, said)


def _check_task(section: TaskSection, path: Path, checked: Checked) -> None:
    """Note a task said in no way, in two, or without any wrench."""
    given = [key for key in ("polytope", "ellipsoid") if checked.has(*path, key)]
    if not given:
        checked.fault(path, "should say its wrenches, by polytope or by ellipsoid", got=False)
    elif len(given) > 1:
        said = "polytope and ellipsoid each say the wrenches; keep one"
        checked.fault(path, said, got=False)
    for key in given:
        rows = getattr(section, key) or [[1.0]]
        if not any(value for row in rows for value in row):
            checked.fault((*path, key), "should hold a wrench that is not zero")
