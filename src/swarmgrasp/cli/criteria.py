"""What a command is asked about the swarm, by its options and by the scenario."""

from typing import TYPE_CHECKING

from swarmgrasp.cli.inputs import UsageFault, whole_faults
from swarmgrasp.cli.question import missing

if TYPE_CHECKING:
    from swarmgrasp.quality import Criterion
    from swarmgrasp.scenario import Scenario


def losing_faults(losing: str | None) -> list[str]:
    """Return what is wrong with --losing."""
    return whole_faults("--losing", losing, 0, 999_999)


def criterion_of(
    scenario: "Scenario", file: str, losing: str | None, worst_case: bool, more: int = 0
) -> "Criterion":
    """Return the scenario's criterion, as changed by options.

    Parameters
    ----------
    scenario : Scenario
    file : str
        What messages call it.
    losing, worst_case
        The options.
    more : int
        Robots that will be there beside those of the scenario.

    Raises
    ------
    UsageFault
        If all robots are to be lost, or the worst case is asked for and nothing has a tolerance.
    """
    from dataclasses import replace

    criterion = scenario.criterion
    newcomer = scenario.newcomer
    is_sure = not scenario.swarm.tolerances and not (newcomer and newcomer.tolerance)
    if worst_case and is_sure:
        advice = (
            "no robot has a tolerance, so --worst-case asks for nothing; give some, such as "
            "`tolerance: {contact: 2, direction: 5}`"
        )
        raise missing(scenario, file, "tolerance", "--worst-case", advice)
    robots = int(scenario.swarm.machines.max(initial=-1)) + 1 + more
    if losing is not None and int(losing) >= max(robots, 1):
        what = "robots and groups" if scenario.swarm.rare.groups else "robots"
        raise UsageFault(
            f"--losing is {int(losing)}, and there are {robots} {what}: none would be left"
        )
    if losing is not None:
        criterion = replace(criterion, losing=int(losing))
    return replace(criterion, worst_case=True) if worst_case else criterion
