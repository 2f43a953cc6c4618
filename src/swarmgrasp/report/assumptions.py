"""What the numbers of a sheet assume, and what they leave out."""

from swarmgrasp.environment import Environment, WindTable
from swarmgrasp.scenario import Scenario


def assumptions(scenario: Scenario) -> list[str]:
    """Say what the numbers about a job assume, and what is not modelled.

    Parameters
    ----------
    scenario : Scenario
    """
    robot, robots = scenario.terms.robot, scenario.terms.several
    is_sure = not scenario.criterion.worst_case
    said = [
        "The object is rigid, and all forces lie in the plane of its outline: lift, heel and trim "
        "are not modelled.",
        "Everything stands still: what motion, delays and the order of commands do is not "
        "counted; the command simulate asks that.",
        f"Each {robot} exerts any force up to its limit at once with all others: thrust lost to "
        "current, waves, wash and shared power is not counted, unless the limits allow for it.",
        f"Pads, lines, bollards and the object's structure bear what the {robots} exert; their "
        "strength is not checked.",
        f"The {robots} stand where the file says they do"
        + (": how far they may be off is not counted." if is_sure else ", within its tolerances."),
    ]
    if scenario.newcomer is not None:
        said.append(
            "A place is good for the force it brings; how to get there, and depth, traffic and "
            "room to work, are not counted but for the zones, no-go stretches, spacing and bodies "
            "given, and for lines, which run free of the object."
        )
    if scenario.environment is None:
        return [*said, "Wind, current and waves are not modelled: the file gives no environment."]
    return [*said, *_weather(scenario.environment)]


def _weather(environment: Environment) -> list[str]:
    """Say what of the weather is counted."""
    factor = environment.dynamic_factor
    allowance = f"the factor {factor:g} on all loads" if factor != 1.0 else "no allowance"
    waves = "the mean drift only" if environment.waves is not None else "nothing"
    current = "its steady drag" if environment.current is not None else "nothing"
    coefficients = (
        "Drag coefficients are general ones for a kind of vessel, or those of the file; none was "
        "measured on this object by the program."
    )
    if isinstance(environment.wind, WindTable):
        coefficients = "The loads of the wind are those of the table given."
    return [
        f"Wind is steady: for gusts and slow drift there is {allowance}.",
        f"Of the current {current} is counted, of waves {waves}.",
        coefficients,
        "Nothing here claims compliance with a rule or a standard.",
    ]
