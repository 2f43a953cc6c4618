"""A failing schedule made smaller, as long as the same invariant breaks."""

from collections.abc import Callable, Iterator
from dataclasses import replace

from swarmgrasp.agents.simulator.faults import LASTING, Fault, Schedule, What
from swarmgrasp.agents.simulator.outcome import Outcome
from swarmgrasp.errors import ScheduleInvalid

MOST_SCHEDULES = 600
"""Schedules that are tried at most."""


def shrink(
    outcome: Outcome,
    run: Callable[[Schedule], Outcome],
    told: Callable[[int], None] | None = None,
) -> Outcome:
    """Return a failing schedule with fewer robots and fewer, shorter faults, and what comes of it.

    Parameters
    ----------
    outcome : Outcome
        Of a schedule in which an invariant breaks.
    run : callable
        Runs a schedule.
    told : callable, optional
        Is told how many runs are done.

    Returns
    -------
    Outcome
        In which the same invariant breaks; the one given if it holds.
    """
    if outcome.broken is None:
        return outcome
    runs, found = 0, True
    while found:
        found = False
        for smaller in _smaller(outcome.schedule):
            if runs >= MOST_SCHEDULES:
                return outcome
            runs += 1
            if told is not None:
                told(runs)
            tried = run(smaller)
            if tried.broken and tried.broken.invariant == outcome.broken.invariant:
                outcome, found = tried, True
                break
    return outcome


def _smaller(schedule: Schedule) -> Iterator[Schedule]:
    """Yield schedules that are a little smaller, those that save most first."""
    if schedule.begin > 2 * schedule.groups:
        yield replace(schedule, begin=schedule.begin // 2)
    for name in reversed(schedule.names):
        yield from _with(schedule, [_without(each, name) for each in schedule.faults])
    count = len(schedule.faults)
    size = count // 2
    while size:
        for start in range(0, count, size):
            yield from _with(schedule, [*schedule.faults[:start], *schedule.faults[start + size :]])
        size //= 2
    for what, value in (
        ("missed", 0.0), ("turned", 0.0), ("locks", False), ("doubled", 0.0), ("loss", 0.0),
        ("delay", 0.02),
    ):  # fmt: skip
        if getattr(schedule, what) != value:
            yield replace(schedule, **{what: value})  # type: ignore[arg-type]
    last = max(each.until if each.what in LASTING and each.until <= schedule.calm else each.at
               for each in schedule.faults)  # fmt: skip
    if schedule.calm > last + 1.0:
        yield replace(schedule, calm=float(round(last + 1.0)))
    for k, fault in enumerate(schedule.faults):
        for shorter in _shorter(fault):
            faults = [*schedule.faults]
            faults[k] = shorter
            yield replace(schedule, faults=tuple(faults))


def _with(schedule: Schedule, faults: list[Fault | None]) -> Iterator[Schedule]:
    """Yield a schedule with these faults, if there is one."""
    left = tuple(each for each in faults if each is not None)
    if left and len(left) <= len(schedule.faults) and left != schedule.faults:
        try:
            yield replace(schedule, faults=left)
        except ScheduleInvalid:  # of nobody
            return


def _without(fault: Fault, name: str) -> Fault | None:
    """Return a fault without a robot, if something is left of it."""
    if name not in fault.names:
        return fault
    names = tuple(each for each in fault.names if each != name)
    return replace(fault, names=names) if fault.what is What.SPLIT and names else None


def _shorter(fault: Fault) -> Iterator[Fault]:
    """Yield a fault with rounder times."""
    for digits in (0, 1):
        at = round(fault.at, digits)
        if at != fault.at and at < fault.until:
            yield replace(fault, at=at)
        if fault.what in LASTING and round(fault.until, digits) != fault.until > at:
            until = round(fault.until, digits)
            if until > fault.at:
                yield replace(fault, until=until)
