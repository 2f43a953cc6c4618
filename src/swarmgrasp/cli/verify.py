"""`swarmgrasp verify`: check an answer without trusting it."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.inputs import (
    STDIN,
    json_faults,
    read_stdin,
    source_of,
)
from swarmgrasp.cli.wording import AS_FILED, Phrasing
from swarmgrasp.errors import AnswerInvalid, SwarmGraspError

if TYPE_CHECKING:
    from swarmgrasp.terms import Terms

REFUSED = 1


def verify(answer: Dashed, /, *, json: Dashed | None = None, phrasing: Phrasing = AS_FILED) -> int:
    """Check an answer of `swarmgrasp place --json`, trusting nothing.

    Code that shares nothing with the search recomputes from the file that every robot stands
    where it may, every quality, and that no allowed place exceeds the upper bound. It does not
    check the reason given in words, nor whether the file asks your question.

    Exit status: 0 verified, 1 refused, 2 when the file cannot be read as an answer.

    Example: swarmgrasp place deck-barge --json barge.json && swarmgrasp verify barge.json

    Parameters
    ----------
    answer
        Answer in JSON, or "-" for standard input. Told in the units of the file that it answers.
    json
        Also write the verdict to this .json file; "-" prints it and nothing else.
    """
    faults = json_faults(json)
    try:
        document = _read(answer)
    except SwarmGraspError as error:
        raise AnswerInvalid([*faults, *error.faults]) from None
    if faults:
        raise AnswerInvalid(faults)
    from swarmgrasp.answer_file import sealed
    from swarmgrasp.cli.show.verdict import largest_gap, show
    from swarmgrasp.verify import verify_document

    name = source_of(answer)
    try:
        terms = phrasing.of(_terms(document))
        verdict = verify_document(document)
    except AnswerInvalid as error:
        raise AnswerInvalid(f"{name}: {fault}" for fault in error.faults) from None
    told = {**verdict.to_data(), "gap": largest_gap(document, verdict)}
    deliver(
        json,
        sealed("verdict", told, str(document["name"])),
        lambda: show(name, document, verdict, terms),
    )
    return 0 if verdict else REFUSED


def _terms(document: dict[str, Any]) -> "Terms":
    """Return the terms in which an answer is told; an answer of Python may have none."""
    from swarmgrasp.plain import read
    from swarmgrasp.terms import SI, Terms

    faults: list[str] = []
    found: Terms | None = None
    if document.get("terms") is not None:
        found = read(document["terms"], Terms, ("terms",), faults)
    if faults:
        raise AnswerInvalid(faults)
    return found or SI


def _read(answer: str) -> dict[str, Any]:
    """Read an answer from a file or from standard input; tell at once what is none."""
    from swarmgrasp.answer_file import LARGEST_FILE, format_of, parse_answer, read_answer

    name = source_of(answer)
    no_answer = f"{name}: not an answer file; `swarmgrasp place --json` writes one"
    try:
        if answer == DASH:
            document = parse_answer(read_stdin(LARGEST_FILE), STDIN)
        else:
            document = read_answer(answer)
    except AnswerInvalid as error:
        readable = answer == DASH or (os.access(answer, os.R_OK) and not Path(answer).is_dir())
        raise AnswerInvalid([*[no_answer][: int(readable)], *error.faults]) from None
    kind = str(document.get("format"))
    if not kind.startswith("swarmgrasp "):
        raise AnswerInvalid(no_answer)
    if kind != format_of("placements"):
        raise AnswerInvalid(
            f"{name}: the format is {kind!r}, which carries no proof that could be checked here; "
            f"{format_of('placements')!r} does, which `swarmgrasp place --json` writes"
        )
    return document
