"""What commands take from the question of a file, and what they say where it holds too little.

An answer file holds the question of the command that wrote it and no more: asked of another
command, it may lack what that one needs.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from swarmgrasp.cli.inputs import UsageFault, is_written, source_of
from swarmgrasp.cli.show.report import complain

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario

ABOUT = {
    "placements": "where robots go",
    "together": "where robots go together",
    "count": "how many robots it takes",
    "move": "which robot should move",
    "quality": "quality",
    "forces": "push forces",
    "forces along": "push forces",
    "capability": "the largest wind held",
    "capability numbers": "the weather held",
    "thrust use": "thrust use",
    "capability with newcomer": "the largest wind held",
    "run": "what becomes of the object in weather",
    "winds": "the largest wind held",
    "judgement": "quality",
}
"""What the questions in answer files are about, by kind of answer."""
CALLED = {
    "newcomer": "newcomer",
    "losing": "loss",
    "failures": "failure",
    "worst_case": "worst case",
    "load": "load",
    "task": "task",
}
"""What parts of a question are called where they are missing: the newcomer, and a criterion's."""


def asked_before(scenario: "Scenario", *kinds: str) -> Mapping[str, Any]:
    """Return the answer that a scenario was read from if it is of such a kind, else nothing."""
    from swarmgrasp.answer_file import format_of

    answer = scenario.answer or {}
    return answer if answer.get("format") in [format_of(kind) for kind in kinds] else {}


def missing(scenario: "Scenario", file: str, what: str, needed_by: str, advice: str) -> UsageFault:
    """Return the error for a question that holds too little.

    Parameters
    ----------
    scenario : Scenario
    file : str
        What it was read from.
    what : str
        What is missing, in a word.
    needed_by : str
        The command or option.
    advice : str
        What is wrong with a scenario file in which it is missing, and what to write there.
    """
    if scenario.answer is None:
        where = f"{source_of(file)}:1:1" if is_written(file) else f"{file}, a built-in example"
        return UsageFault(f"{where}: {advice}")
    return UsageFault(
        f"{_holds(scenario, file, [what])}: {needed_by} needs one; ask it of the scenario"
    )


def check_newcomer(scenario: "Scenario", file: str, command: str) -> None:
    """Raise `UsageFault` if there is no newcomer, whom a command needs."""
    if scenario.newcomer is None:
        advice = (
            f"has no newcomer, and `swarmgrasp {command}` needs one; add one, such as "
            "`newcomer: {limit: 1000, attachment: push}`"
        )
        raise missing(scenario, file, "newcomer", f"`swarmgrasp {command}`", advice)


def tell_omitted(scenario: "Scenario", file: str, command: str, **uses: object) -> None:
    """Say on standard error what a command could use and the question of an answer does not hold.

    Parameters
    ----------
    scenario : Scenario
    file : str
        What it was read from.
    command : str
    **uses
        What the command takes from a question, by the keys of `CALLED`, each with the option that
        says it instead, or None.
    """
    answer = scenario.answer or {}
    if not answer or "problem" in answer:
        return
    held = {*answer, *(answer.get("criterion") or ())}
    lacking = [CALLED[key] for key, option in uses.items() if not option and key not in held]
    if lacking:
        complain([f"{_holds(scenario, file, lacking)}: `swarmgrasp {command}` goes without"])


def _holds(scenario: "Scenario", file: str, lacking: list[str]) -> str:
    """Return what the question of an answer file is about, and what it does not hold."""
    kind = str((scenario.answer or {})["format"]).removeprefix("swarmgrasp ").rpartition(" ")[0]
    words = " or ".join(filter(None, [", ".join(lacking[:-1]), lacking[-1]]))
    return f"{source_of(file)} holds a question about {ABOUT.get(kind, kind)}, with no {words}"
