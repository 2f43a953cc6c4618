"""`swarmgrasp judge`: let MuJoCo say whether a quality is right."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.amounts import Amount
from swarmgrasp.cli.criteria import criterion_of, losing_faults
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.inputs import blaming, json_faults, output_faults, read_scenario
from swarmgrasp.cli.question import asked_before, missing, tell_omitted
from swarmgrasp.cli.wording import FILE, Wording

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.simulation import Hull

REFUSED = 1
"""The exit status if MuJoCo does not agree."""


def judge(
    file: Dashed,
    /,
    *,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    failures: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    mass: Annotated[str | None, Parameter(metavar="MASS")] = None,
    mjcf: Path | None = None,
    json: Dashed | None = None,
    wording: Wording = FILE,
) -> int:
    """Let MuJoCo, a simulator of others, say whether the quality is right.

    In the weakest direction comes a disturbance of 99 %, 100 % and 101 % of the quality, and
    the robots answer it with the forces of `swarmgrasp forces`. The first two should be held:
    after a minute the object is where it was. The third should not.

    Needs the extra: pip install 'swarmgrasp[mujoco]'

    Exit status: 0 if MuJoCo agrees, 1 if not.

    Example: swarmgrasp judge escort-ring --losing 1 --mjcf ring.xml

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        escort-ring. Its newcomer is left out.
    losing
        The quality after the worst loss of so many robots.
    failures
        The quality after the worst of these failures, before any loss: a robot or a group by
        name, or several that fail together, with commas. Give it once for each. Instead of those
        in the file.
    worst_case
        The quality in the worst poses that the robots' tolerances allow.
    mass
        Of the object, such as 400t, spread evenly; in kilograms without a unit. By default that of
        the scenario's simulation, or of the water that its current and outline tell it displaces.
    mjcf
        Write the object and its robots as a model, .xml, for MuJoCo's viewer:
        python -m mujoco.viewer --mjcf=ring.xml
    json
        Also write what MuJoCo says to this .json file; "-" prints it and nothing else. SI units and
        radians.
    """
    from swarmgrasp.packages import check_installed
    from swarmgrasp.simulation.hull import MASS

    check_installed("mujoco", extra="mujoco", purpose="`swarmgrasp judge`")
    faults = losing_faults(losing) + output_faults(mjcf, (".xml",))
    faults += json_faults(json) + wording.faults(json)
    weighed = None if mass is None else Amount("--mass", mass, "mass", MASS.low, MASS.high)
    faults += [] if weighed is None else weighed.faults()
    scenario = read_scenario(file, faults)
    criterion = criterion_of(scenario, file, losing, worst_case, failures)
    hull = _hull(scenario, file, None if weighed is None else weighed.value())
    tell_omitted(
        scenario, file, "judge",
        losing=losing, failures=failures, worst_case=worst_case, load=None, task=None,
    )  # fmt: skip
    from swarmgrasp.answer_file import sealed
    from swarmgrasp.cli.show.judge import show
    from swarmgrasp.quality import quality as quality_of
    from swarmgrasp.simulation.mujoco import judge as judge_of

    with blaming(file):
        found = judge_of(quality_of(scenario.swarm, **criterion.keywords), hull)
    terms = wording.terms(scenario)
    deliver(
        json,
        sealed(
            "judgement",
            {**found.to_data(), "agrees": bool(found)},
            scenario.name,
            terms=scenario.terms,
        ),
        lambda: show(scenario.name, scenario.swarm, found, terms),
        lambda: [] if mjcf is None else [_written(scenario, hull, mjcf)],
        csv=wording.csv,
    )
    return 0 if found else REFUSED


def _hull(scenario: "Scenario", file: str, mass: float | None) -> "Hull":
    """Return what the object weighs.

    Raises
    ------
    UsageFault
        If nothing tells it.
    """
    from swarmgrasp.simulation import Hull

    if mass is not None:
        return Hull.ashore(scenario.swarm.outline, mass)
    before = asked_before(scenario, "judgement").get("hull")
    if before is not None:
        with blaming(file):
            return Hull.from_data(before)
    if scenario.simulation is not None:
        return scenario.simulation.hull
    environment = scenario.environment
    if environment is None or environment.current is None:
        advice = (
            "nothing tells the mass of the object; give --mass, such as --mass 400t, or the "
            "environment's current, whose lateral area tells how deep it floats"
        )
        raise missing(scenario, file, "mass", "`swarmgrasp judge`", advice)
    return Hull.afloat(scenario.swarm.outline, environment)


def _written(scenario: "Scenario", hull: "Hull", path: Path) -> Path:
    """Write the model, with the robots' lags where a simulation tells them; return its path."""
    from swarmgrasp.files import write_whole
    from swarmgrasp.simulation.mujoco import mjcf

    swarm, simulation = scenario.swarm, scenario.simulation
    lags = [0.0] * len(swarm)
    if simulation is not None:
        own = dict(simulation.actuators)
        lags = [own.get(name, simulation.actuator).lag for name in swarm.names]
    write_whole(str(path), mjcf(swarm, hull, lags=lags, name=scenario.name).encode())
    return path
