"""Answer files: any answer with its question, as JSON that a stranger can check and ask again."""

import json
import os
import sys
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from swarmgrasp.errors import AnswerInvalid, refuse
from swarmgrasp.files import MOST_DEPTH, read_fault, target_faults, write_whole
from swarmgrasp.plain import Answer
from swarmgrasp.ranges import kind_faults, name_faults, path_faults
from swarmgrasp.terms import SI, Terms
from swarmgrasp.verify.digest import digest_of

REVISION = 3
"""Of the form of answer files."""
UNITS = "SI: m, N, N m, rad"
LARGEST_FILE = 50_000_000
"""Bytes; an answer for 1 000 robots takes about 0.2 MB."""


def document_of(
    answer: Answer, name: str = "", date: datetime | None = None, terms: Terms = SI
) -> dict[str, Any]:
    """Return an answer as the plain data of an answer file.

    Parameters
    ----------
    answer : Answer
        Of any kind, as functions of this package give it.
    name : str
        What the answer is called, such as the scenario's name.
    date : datetime, optional
        When it was found, with its time zone; now when left out, or what the environment variable
        SOURCE_DATE_EPOCH says [s since 1970], which makes files reproducible.
    terms : Terms
        In which commands tell it; its numbers are in SI units all the same.
    """
    faults = kind_faults(answer, Answer, "place(...)") + name_faults(name)
    if date is not None:
        faults += kind_faults(date, datetime, "datetime.now(UTC)")
    faults += kind_faults(terms, Terms, "Terms(...)")
    refuse((AnswerInvalid, faults))
    return sealed(answer.kind, answer.to_data(), name, date, terms)


def sealed(
    kind: str,
    content: dict[str, Any],
    name: str = "",
    date: datetime | None = None,
    terms: Terms = SI,
) -> dict[str, Any]:
    """Return the content of an answer file with what it is, who made it when, and its digest."""
    document = {
        "format": format_of(kind),
        "name": name,
        "version": version("swarmgrasp"),
        "date": (date or _now()).astimezone(UTC).strftime("%Y-%m-%dT%H:%M:%SZ"),
        "units": UNITS,
        **({} if terms == SI else {"terms": terms.to_data()}),
        **content,
    }
    return {**document, "digest": digest_of(document)}


def format_of(kind: str) -> str:
    """Return what the `format` of a file says that holds a kind of answer."""
    return f"swarmgrasp {kind} {REVISION}"


def document_text(document: dict[str, Any]) -> str:
    """Return plain data as the text of a JSON file."""
    return json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def write_answer(
    path: str | Path,
    answer: Answer,
    name: str = "",
    date: datetime | None = None,
    terms: Terms = SI,
) -> None:
    """Write an answer to a JSON file, whole or not at all.

    Parameters
    ----------
    path : str or Path
    answer : Answer
        Of any kind: a `Placement` or several in a row, a `Quality`, a `Move` and so on.
    name, date, terms
        The file's own entries: a title, when the answer was found, now when left out, or what the
        environment variable SOURCE_DATE_EPOCH says, and in which terms commands tell it, such as
        `Scenario.terms`.

    Raises
    ------
    AnswerInvalid
        If the answer, the path, the name, the date or the terms are none, or the path's folder
        may not be written to.
    OSError
        If the file cannot be written for another reason.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from swarmgrasp import Newcomer, Outline, Robot, Swarm, place
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> crew = [Robot((1, 0.3), 3.0), Robot((-1, 0.5), 0.4), Robot((0.2, -1), 1.7)]
    >>> answer = place(Swarm(square, crew), Newcomer(attachment="push"))
    >>> with TemporaryDirectory() as folder:
    ...     write_answer(f"{folder}/answer.json", answer, "square")
    ...     read_answer(f"{folder}/answer.json")["format"]
    'swarmgrasp placements 3'
    """
    refuse((AnswerInvalid, path_faults(path) or target_faults(Path(path))))
    write_whole(path, document_text(document_of(answer, name, date, terms)).encode())


def read_answer(path: str | Path) -> dict[str, Any]:
    """Read an answer file, unchecked but for being JSON.

    Raises
    ------
    AnswerInvalid
        If it cannot be read, is too large or nested too deep, or is not a JSON object; with file
        and line.
    """
    refuse((AnswerInvalid, path_faults(path)))
    try:
        with Path(path).open("rb") as file:
            return parse_answer(file.read(LARGEST_FILE + 1), str(path))
    except OSError as error:
        raise AnswerInvalid(read_fault(path, error)) from None


def parse_answer(content: bytes, source: str) -> dict[str, Any]:
    """Read an answer from the bytes of a file, which messages call `source`.

    Raises
    ------
    AnswerInvalid
        As for `read_answer`.
    """
    if len(content) > LARGEST_FILE:
        raise AnswerInvalid(f"{source}: more than {LARGEST_FILE} bytes, too many for an answer")
    deep = f"{source}: nested too deep; at most {MOST_DEPTH} levels are read"
    try:
        document = json.loads(content.decode())
    except UnicodeDecodeError as error:
        raise AnswerInvalid(f"{source}: not UTF-8 text (byte {error.start})") from None
    except json.JSONDecodeError as error:
        raise AnswerInvalid(f"{source}:{error.lineno}:{error.colno}: {error.msg}") from None
    except ValueError:
        digits = sys.get_int_max_str_digits()
        raise AnswerInvalid(f"{source}: holds a number of more than {digits} digits") from None
    except RecursionError:
        raise AnswerInvalid(deep) from None
    if not isinstance(document, dict):
        raise AnswerInvalid(f"{source}:1:1: an answer is a JSON object")
    if _is_deep(document):
        raise AnswerInvalid(deep)
    return document


def _is_deep(document: dict[str, Any]) -> bool:
    """Tell whether data nest deeper than `MOST_DEPTH`."""
    level: list[Any] = [document]
    for _ in range(MOST_DEPTH):
        parts = (each.values() if isinstance(each, dict) else each for each in level)
        level = [part for row in parts for part in row if isinstance(part, dict | list)]
    return bool(level)


def _now() -> datetime:
    """Return the time that answers are of."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    try:
        return datetime.fromtimestamp(int(given), UTC) if given else datetime.now(UTC)
    except (ValueError, OverflowError, OSError):
        raise AnswerInvalid(
            f"SOURCE_DATE_EPOCH is {given!r}; it should be a whole number of seconds since 1970"
        ) from None
