"""`swarmgrasp report`: one sheet about one job, to be read, printed and signed."""

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import STDIN, UsageFault, blaming, output_faults, read_scenario
from swarmgrasp.cli.pictures import drawing
from swarmgrasp.cli.show.report import complain, told_written
from swarmgrasp.cli.weather import CALM, Weather
from swarmgrasp.cli.wording import AS_FILED, Phrasing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from swarmgrasp.placement import Placement
    from swarmgrasp.report import Origin, Section, Sheet
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.swarm import Swarm
    from swarmgrasp.terms import Terms
    from swarmgrasp.verify import Verdict

REFUSED = 1
"""Exit status when the answer in a file does not hold."""
MOST_LOST = 100
"""Robots and groups up to which it is told what the loss of each leaves."""


def report(
    file: Dashed,
    page: Path,
    /,
    *,
    markdown: Path | None = None,
    date: Annotated[str | None, Parameter(metavar="YYYY-MM-DD")] = None,
    weather: Weather = CALM,
    phrasing: Phrasing = AS_FILED,
) -> int:
    """Write one sheet about one job, to be read, printed and signed.

    It holds the question in words, the plan, where the newcomer goes with the proof and what
    `swarmgrasp verify` says of it, what the loss of each robot leaves, the largest wind held from
    every bearing and the push forces in the weather given, what all that assumes and what is not
    modelled, version, date and digests of the inputs, and lines for signatures. Without a newcomer
    it is about the robots that are there.

    Exit status: 0 written; 1 the answer in the file does not hold, and nothing is written.

    Example: swarmgrasp report deck-barge barge.html

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge; or an
        answer of `swarmgrasp place`, which is then checked and told, not found anew.
    page
        The sheet, an .html file that needs no other file and no network.
    markdown
        Also write it to this .md file, its drawings beside it.
    date
        Of the answer, instead of today; an answer file has its own.
    """
    faults = output_faults(page, (".html",)) + output_faults(markdown, (".md",))
    faults += _date_faults(date) + weather.faults()
    scenario = read_scenario(file, faults)
    if scenario.answer is not None:
        _check_answer(scenario.answer, file, date, weather)
    job = _solved(weather.on(scenario, file, phrasing), file, _source_of(file), date)
    if job.verdict is not None and not job.verdict:
        complain(f"{job.source}: {fault}" for fault in job.verdict.faults)
        complain([f"{job.source}: the answer is refused, and {page} is not written"])
        return REFUSED
    with blaming(file):
        sheet = _sheet(job, phrasing.terms(job.scenario))
    _write(sheet, page, markdown)
    return 0


def html_of(scenario: "Scenario", source: str, text: str) -> str:
    """Return the sheet about a scenario, as one HTML file.

    Parameters
    ----------
    scenario : Scenario
    source : str
        What the sheet calls the file.
    text : str
        What stands in it.
    """
    job = _solved(scenario, source, (source, text.encode()), None)
    return _sheet(job, scenario.terms).html()


@dataclass(frozen=True)
class _Job:
    """A job with its answer.

    Attributes
    ----------
    scenario : Scenario
    source : str
        What messages and the sheet call its file.
    answers : sequence of Placement
        None of a job without a newcomer.
    document : mapping
        The answer as an answer file has it.
    verdict : Verdict or None
        What verify says of it; None where there is nothing to place.
    origin : Origin
    """

    scenario: "Scenario"
    source: str
    answers: "Sequence[Placement]"
    document: Mapping[str, Any]
    verdict: "Verdict | None"
    origin: "Origin"

    @property
    def swarm(self) -> "Swarm":
        """The robots that are there in the end."""
        return self.answers[-1].swarm_after if self.answers else self.scenario.swarm

    @property
    def held(self) -> "Scenario":
        """The scenario with these robots, and nobody to come."""
        return replace(self.scenario, swarm=self.swarm, newcomer=None)


def _date_faults(date: str | None) -> list[str]:
    """Return what is wrong with a date."""
    try:
        if date is None or datetime.strptime(date, "%Y-%m-%d").strftime("%Y-%m-%d") == date:
            return []
    except ValueError:
        pass
    return [f"--date is {date}; it should be a day such as 2026-03-31"]


def _check_answer(answer: Mapping[str, Any], file: str, date: str | None, weather: Weather) -> None:
    """Raise `UsageFault` if an answer file has no proof, or is to be of another day or weather."""
    from swarmgrasp.answer_file import format_of
    from swarmgrasp.cli.inputs import source_of

    faults = []
    if answer["format"] != format_of("placements"):
        faults.append(
            f"{source_of(file)}: the format is {answer['format']!r}, which carries no proof; give "
            f"an answer of `swarmgrasp place --json`, {format_of('placements')!r}, or a scenario"
        )
    if date is not None:
        faults.append(
            f"--date is {date}, and {source_of(file)} says when its answer was found; leave it out"
        )
    if weather.given:
        faults.append(
            f"{next(iter(weather.given))} asks another question than the one that "
            f"{source_of(file)} answers; leave it out, or give the scenario"
        )
    if faults:
        raise UsageFault(faults)


def _solved(
    scenario: "Scenario", file: str, source: tuple[str, bytes | None], date: str | None
) -> _Job:
    """Answer a job, or take the answer that stands in its file, and check it."""
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.place import solve
    from swarmgrasp.placement.stated import placements_in
    from swarmgrasp.quality import quality
    from swarmgrasp.verify import verify_document

    day = None if date is None else datetime.strptime(date, "%Y-%m-%d").replace(tzinfo=UTC)
    answers: Sequence[Placement] = ()
    verdict, document = None, scenario.answer
    if document is None and scenario.newcomer is not None:
        answers = solve(scenario, file)
        document = document_of(answers, scenario.name, day, scenario.terms)
    if document is None:
        with blaming(file):
            found = quality(scenario.swarm, **scenario.criterion.keywords)
        document = document_of(found, scenario.name, day, scenario.terms)
    else:
        with blaming(file):
            verdict = verify_document(dict(document))
        if verdict and not answers:
            answers = placements_in(document)
    origin = _origin(scenario, *source, date or str(document["date"])[:10])
    return _Job(scenario, origin.source, answers, document, verdict, origin)


def _source_of(file: str) -> tuple[str, bytes | None]:
    """Return what the sheet calls a file, and what stands in it; None of standard input."""
    from swarmgrasp.scenario import example_text

    if file == DASH:
        return STDIN, None
    if os.path.lexists(file):
        return Path(file).name, Path(file).read_bytes()
    return f"{file}, a built-in example", example_text(file).encode()


def _origin(scenario: "Scenario", source: str, content: bytes | None, date: str) -> "Origin":
    """Return where the numbers come from."""
    import hashlib
    from importlib.metadata import version

    from swarmgrasp.plain import plain
    from swarmgrasp.report import Origin
    from swarmgrasp.verify.digest import digest_of

    asked = {"problem": scenario.problem().to_data(), "environment": plain(scenario.environment)}
    return Origin(
        version=version("swarmgrasp"),
        date=date,
        source=source,
        file_digest="" if content is None else hashlib.sha256(content).hexdigest(),
        question_digest=digest_of(asked).removeprefix("sha256:"),
    )


# -- what stands on it ---------------------------------------------------------------------


def _sheet(job: _Job, terms: "Terms") -> "Sheet":
    """Return the sheet about a job."""
    from swarmgrasp.pages.page import Points
    from swarmgrasp.report import Section, Sheet, assumptions

    scenario = job.scenario
    sections = [_question(job, terms)]
    if job.answers:
        sections += _placed(job, terms)
    sections.append(_quality(job, terms))
    sections += [*_forces(job, terms), *_capability(job, terms)]
    told = Section("What this assumes, and what is not modelled", [Points(assumptions(scenario))])
    return Sheet(scenario.name, scenario.description, [*sections, told], job.origin)


def _question(job: _Job, terms: "Terms") -> "Section":
    """Return the question in words."""
    from swarmgrasp.cli.show.change import telling_of
    from swarmgrasp.cli.show.held import weather_words
    from swarmgrasp.report import Section, question

    scenario = job.scenario
    tell = telling_of(terms, scenario.swarm, [], scenario.newcomer)
    has_load = scenario.criterion.has_load
    weather = weather_words(scenario, scenario.criterion.load, tell) if has_load else ""
    return Section("Question", [question(scenario, tell, weather)])


def _placed(job: _Job, terms: "Terms") -> list["Section"]:
    """Return where newcomers go, and what the check says."""
    from swarmgrasp.cli.show.held import weather_of
    from swarmgrasp.cli.show.placement import show
    from swarmgrasp.cli.show.sheet import section
    from swarmgrasp.cli.show.verdict import show as show_verdict
    from swarmgrasp.plot import plan
    from swarmgrasp.quality import quality

    scenario, verdict, document = job.scenario, job.verdict, dict(job.document)
    assert verdict is not None
    before = quality(scenario.swarm, **scenario.criterion.keywords)
    picture = plan(
        scenario.swarm, quality=before, placements=job.answers,
        environment=scenario.environment, terms=terms,
    )  # fmt: skip
    drawn = drawing("plan", picture, f"Plan of {scenario.name}, with the answer.")
    weather = weather_of(scenario, terms)
    answer = section(
        "Answer", lambda: show(scenario.name, job.answers, terms, weather=weather), drawn
    )
    return [answer, section("Check", lambda: show_verdict("Answer", document, verdict, terms))]


def _quality(job: _Job, terms: "Terms") -> "Section":
    """Return how well the robots hold the object, and what the loss of each leaves."""
    from swarmgrasp.cli.show.quality import show
    from swarmgrasp.cli.show.sheet import section
    from swarmgrasp.plot import plan
    from swarmgrasp.quality import losses, quality

    swarm, criterion = job.swarm, job.scenario.criterion
    found = quality(swarm, **criterion.keywords)
    few = _machines(swarm) <= MOST_LOST
    lost = losses(swarm, **replace(criterion, losing=0).keywords) if few else ()
    alone = lost if few and criterion.has_load and not criterion.is_of_worst else None
    drawn = []
    if not job.answers:
        picture = plan(
            swarm, quality=found, zones=job.scenario.zones or (), no_go=job.scenario.no_go,
            environment=job.scenario.environment, terms=terms,
        )  # fmt: skip
        drawn.append(drawing("plan", picture, f"Plan of {job.scenario.name}."))
    title = "All of them together" if job.answers else "How well the object is held"
    return section(title, lambda: show(job.held, found, lost, None, terms, alone), *drawn)


def _forces(job: _Job, terms: "Terms") -> list["Section"]:
    """Return the push forces against the load or in the weather given, if any is."""
    from swarmgrasp.cli.show.forces import show
    from swarmgrasp.cli.show.sheet import section
    from swarmgrasp.forces import forces
    from swarmgrasp.plot import forces_plan

    swarm, criterion, environment = job.swarm, job.scenario.criterion, job.scenario.environment
    if criterion.has_load:
        load = criterion.load
    elif environment is not None and environment.is_steady:
        surge, sway, yaw = environment.load(swarm.outline).tolist()
        load = (surge, sway, yaw)
    else:
        return []
    found = forces(swarm, (0.0, 0.0, 0.0), load=load)
    picture = forces_plan(found, environment=environment, terms=terms)
    drawn = drawing("forces", picture, "Push forces against the load.")
    return [section("Push forces", lambda: show(job.held, found, terms), drawn)]


def _capability(job: _Job, terms: "Terms") -> list["Section"]:
    """Return the largest winds held, if the file says what the object shows to the wind."""
    from swarmgrasp.capability import capability
    from swarmgrasp.cli.capability import bearings_apart
    from swarmgrasp.cli.show.capability import show
    from swarmgrasp.cli.show.sheet import section
    from swarmgrasp.plot import capability_diagram

    swarm, criterion, environment = job.swarm, job.scenario.criterion, job.scenario.environment
    losing = criterion.losing or int(not criterion.failures)
    if environment is None or _machines(swarm) <= losing:
        return []
    bearings = bearings_apart(heading=terms.frame.heading)
    asked = environment, bearings, losing, criterion.worst_case, criterion.failures
    found, name = capability(swarm, *asked), job.scenario.name
    start = job.scenario.swarm
    before = capability(start, *asked) if job.answers and _machines(start) > losing else None
    caption = "The largest wind held from every bearing, the bow up."
    picture = capability_diagram(found, name, before=before, terms=terms)
    drawn = drawing("capability", picture, caption)
    return [section("Capability", lambda: show(name, found, terms), drawn)]


def _machines(swarm: "Swarm") -> int:
    """Return how many robots and groups may be lost."""
    return int(swarm.machines.max(initial=-1)) + 1


def _write(sheet: "Sheet", page: Path, markdown: Path | None) -> None:
    """Write a sheet, all of it or nothing; the drawings of Markdown are named after it."""
    from swarmgrasp.files import write_together

    contents = {page: sheet.html().encode()}
    if markdown is not None:
        named = sheet.named(markdown.stem)
        contents[markdown] = named.markdown().encode()
        for name, text in named.drawings().items():
            contents[markdown.with_name(name)] = text.encode()
    write_together(contents)
    told_written(contents)
