"""`swarmgrasp verify`: check an answer without trusting it."""

from typing import TYPE_CHECKING, Any

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import STDIN, json_faults, put_json, read_stdin
from swarmgrasp.errors import AnswerInvalid

if TYPE_CHECKING:
    from swarmgrasp.placement import Verdict

REFUSED = 1


def verify(answer: Dashed, /, *, json: Dashed | None = None) -> int:
    """Check an answer of `swarmgrasp place --json`, trusting nothing.

    Everything is recomputed from the file by code that shares nothing with the search:
    that every robot stands where it may, every quality, and that no allowed place exceeds
    the upper bound.

    Exit status: 0 verified, 1 refused, 2 when the file cannot be read as an answer.

    Example: swarmgrasp place deck-barge --json barge.json && swarmgrasp verify barge.json

    Parameters
    ----------
    answer
        Answer in JSON, or "-" for standard input.
    json
        Also write the verdict to this .json file; "-" prints it and nothing else.
    """
    faults = json_faults(json)
    try:
        document = _read(answer)
    except AnswerInvalid as error:
        raise AnswerInvalid([*faults, *error.faults]) from None
    if faults:
        raise AnswerInvalid(faults)
    from swarmgrasp.placement import verify_document

    name = STDIN if answer == DASH else answer
    try:
        verdict = verify_document(document)
    except AnswerInvalid as error:
        raise AnswerInvalid(f"{name}: {fault}" for fault in error.faults) from None
    if json != DASH:
        show(name, document, verdict)
    put_json(json, data_of(verdict))
    return 0 if verdict else REFUSED


def _read(answer: str) -> dict[str, Any]:
    """Read an answer from a file or from standard input."""
    from swarmgrasp.placement import parse_answer, read_answer
    from swarmgrasp.placement.document import LARGEST_FILE

    return parse_answer(read_stdin(LARGEST_FILE), STDIN) if answer == DASH else read_answer(answer)


def data_of(verdict: "Verdict") -> dict[str, Any]:
    """Return a verdict as plain data."""
    return {
        "verified": bool(verdict),
        "faults": list(verdict.faults),
        "upper_bounds": list(verdict.upper_bounds),
    }


def show(name: str, document: dict[str, Any], verdict: "Verdict") -> None:
    """Write a verdict for people."""
    from swarmgrasp.cli.report import Forces, Report
    from swarmgrasp.cli.words import degrees

    report = Report()
    if verdict:
        report.headline(f"{name}: verified", "good")
    else:
        report.headline(f"{name}: refused, for {_count(len(verdict.faults), 'fault')}", "bad")
        for fault in verdict.faults:
            report.sentence(f"- {fault}")
        return
    report.blank()
    placements = document["placements"]
    facts = []
    for claim, bound in zip(placements, verdict.upper_bounds, strict=True):
        unit = Forces.for_size(claim["quality"], bound)
        robot = claim["robot"]
        x, y = robot["contact"]
        before, after = unit.number(claim["quality_before"]), unit.text(claim["quality"])
        facts += [
            (robot["name"], f"at ({x:.6g}, {y:.6g}) m, {degrees(robot['direction'])} deg"),
            ("", f"quality {before} -> {after}" if claim["improves"] else f"quality {after}"),
            ("", f"no allowed place exceeds {unit.text(bound)}, by a bound recomputed"),
        ]
    report.facts(facts)
    report.blank()
    report.sentence(
        "Recomputed from the file alone: digest, contacts, directions, zones, qualities, and "
        "a bound for every allowed place."
    )
    metric = document["metric"]
    a1, a2 = metric["force_weights"]
    report.note(
        f"Metric: force weights {a1:g} and {a2:g}, characteristic length "
        f"{metric['characteristic_length']:.6g} m."
    )


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
