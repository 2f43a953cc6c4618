"""What came of simulated networks, in words."""

from typing import TYPE_CHECKING, Any

from swarmgrasp.cli.show.report import Report

if TYPE_CHECKING:
    from swarmgrasp.agents.simulator import Outcome

MOST_TOLD = 40
"""Things that robots said before an invariant broke that are shown."""


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
    report.note(f"{messages} messages between {_robots(done)} robots, {counted}.")
    if excused:
        pairs = "pair" if excused == 1 else "pairs"
        report.note(f"{excused} {pairs} attached too close, neither having heard the other.")


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
