"""What a command is asked about the swarm, by its options and by the scenario."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from swarmgrasp.cli.inputs import UsageFault, whole_faults
from swarmgrasp.cli.question import missing
from swarmgrasp.ranges import shown
from swarmgrasp.words import list_words, machine_words

if TYPE_CHECKING:
    from swarmgrasp.quality import Criterion
    from swarmgrasp.scenario import Scenario

MOST_NAMED = 20
"""Robots and groups that a message names."""


def losing_faults(losing: str | None) -> list[str]:
    """Return what is wrong with --losing."""
    return whole_faults("--losing", losing, 0, 999_999)


def failures_of(
    scenario: "Scenario", given: Sequence[str], option: str = "--failures"
) -> tuple[tuple[str, ...], ...]:
    """Return the failures that an option names: each a robot or a group, or several with commas.

    Raises
    ------
    UsageFault
        If no robot and no group has a name; it says which there are.
    """
    swarm = scenario.swarm
    known = list(dict.fromkeys([*swarm.groups, *swarm.names]))
    found = [
        (text,) if text in known else tuple(name.strip() for name in text.split(","))
        for text in given
    ]
    there = [
        *known[:MOST_NAMED],
        *([f"{len(known) - MOST_NAMED} more"] * (len(known) > MOST_NAMED)),
    ]
    faults = [
        f"{option} takes {shown(name)}, which is no robot and no group"
        + (f"; there are {list_words(there)}" if there else "; there are none")
        for names in found
        for name in names
        if name not in known
    ]
    if faults:
        raise UsageFault(faults)
    return tuple(found)


def criterion_of(
    scenario: "Scenario", file: str, losing: str | None, worst_case: bool,
    failures: Sequence[str] | None, more: int = 0,
) -> "Criterion":  # fmt: skip
    """Return the scenario's criterion, as changed by options.

    Parameters
    ----------
    scenario : Scenario
    file : str
        What messages call it.
    losing, worst_case, failures
        The options.
    more : int
        Robots that will be there beside those of the scenario.

    Raises
    ------
    UsageFault
        If all robots are to be lost, the worst case is asked for and nothing has a tolerance, or
        a failure takes nobody.
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
        what = machine_words(robots, bool(scenario.swarm.rare.groups))
        there = "is" if robots == 1 else "are"
        raise UsageFault(
            f"--losing is {int(losing)}, and there {there} {robots} {what}: none would be left"
        )
    if losing is not None:
        criterion = replace(criterion, losing=int(losing))
    if failures:
        criterion = replace(criterion, failures=failures_of(scenario, failures))
    return replace(criterion, worst_case=True) if worst_case else criterion
