"""What came of simulated networks, in words."""

from collections import Counter
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from swarmgrasp.cli.show.report import Report

if TYPE_CHECKING:
    from swarmgrasp.agents.simulator import Census, Outcome

MOST_TOLD = 40
"""Things that robots said before an invariant broke that are shown."""
_HAPPENED = {
    "start": "starts", "join": "joins", "leave": "leaves", "move": "wishes to move",
    "fall": "falls off the object", "hang": "hangs", "crash": "kills",
    "forget": "kills with loss of memory", "cut": "cut links", "deaf": "links cut one way",
    "split": "splits of the network", "jump": "jumps of clocks",
}  # fmt: skip
"""What happens to robots, in words."""


def show(done: "list[Outcome]", last: "Outcome", command: str) -> None:
    """Tell what came of schedules; of one that fails, what happened and how to repeat it."""
    report = Report()
    modes = ", ".join(dict.fromkeys(outcome.schedule.mode.value for outcome in done))
    messages = sum(outcome.messages for outcome in done)
    excused = sum(outcome.excused for outcome in done)
    counted = f"{len(done)} {'schedule' if len(done) == 1 else 'schedules'} of {modes}"
    if last.broken is None:
        report.headline(f"All invariants hold in {counted}", "good")
    else:
        schedule = last.schedule
        words = f"{last.broken.invariant!r} does not hold in {schedule.mode}, seed {schedule.seed}"
        report.headline(words, "bad")
        report.sentence(last.broken.words)
        report.blank()
        told = last.reports[-MOST_TOLD:]
        for time, said in told:
            report.sentence(f"{time:8.2f} s  {said}")
        report.blank()
        report.sentence("To repeat it:")
        report.sentence(command)
        report.blank()
    for outcome in done:
        if outcome.census is not None:
            _tell_groups(report, outcome, outcome.census)
    report.note(f"{messages} messages between {_robots(done)} robots, {counted}.")
    if excused:
        pairs = "pair" if excused == 1 else "pairs"
        report.note(f"{excused} {pairs} attached too close, neither having heard the other.")


def _tell_groups(report: Report, outcome: "Outcome", census: "Census") -> None:
    """Tell what became of a swarm in groups."""
    schedule = outcome.schedule
    happened = Counter(_HAPPENED[each.what] for each in schedule.faults)
    report.sentence(
        f"Seed {schedule.seed}: {schedule.begin} robots in {schedule.groups} groups hold the "
        f"object. {schedule.loss:.0%} of all messages are lost, {schedule.doubled:.0%} come "
        f"twice, each takes {schedule.delay:g} s at the mean."
    )
    report.sentence(
        f"Within {schedule.calm:g} s "
        + ", ".join(f"{words}: {count}" for words, count in happened.items())
        + "; then it is calm."
    )
    report.sentence(
        f"At {outcome.time:.0f} s all is settled: {census.counted} hold the object. Everybody "
        f"knows that the quality is {census.lower:.6g} to {census.upper:.6g} N; it is "
        f"{census.true:.6g} N."
    )
    report.sentence(
        f"A robot has sent {census.sent:.0f} B/s at the mean, {census.most_sent:.0f} B/s at most, "
        f"and received {census.received:.0f} B/s."
    )
    report.blank()


def document_of(done: "list[Outcome]", last: "Outcome", command: str) -> dict[str, Any]:
    """Return what came of schedules, as JSON."""
    broken = last.broken
    return {
        "kind": "simulated networks",
        "schedules": [
            {
                "mode": each.schedule.mode.value,
                "seed": each.schedule.seed,
                "holds": each.broken is None,
                "messages": each.messages,
                "bytes": each.sent,
                "time": each.time,
                "turns": each.turns,
                "excused": each.excused,
                "attached": len(each.places),
                "trace": each.trace,
                "groups": None if each.census is None else asdict(each.census),
            }
            for each in done
        ],
        "broken": None
        if broken is None
        else {
            "invariant": broken.invariant,
            "words": broken.words,
            "command": command,
            "reports": [[time, words] for time, words in last.reports],
        },
    }


def _robots(done: "list[Outcome]") -> str:
    """Return how many robots there were in a schedule."""
    counts = [len(each.schedule.names) for each in done]
    low, high = min(counts), max(counts)
    return f"{low}" if low == high else f"{low} to {high}"
