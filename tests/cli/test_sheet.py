"""One sheet about one job: its numbers, what it refers to, and what names cannot do to it."""

import json
import math
import re
from html.parser import HTMLParser

import numpy as np
import pytest
from matplotlib.figure import Figure

from swarmgrasp import capability, forces, losses, place_sequence, plot
from swarmgrasp.capability import asked
from swarmgrasp.cli import report as command
from swarmgrasp.environment import KNOT
from swarmgrasp.placement.stated import placements_in
from swarmgrasp.scenario import load_example
from swarmgrasp.units import FORCES

UNTITLED = ("meta", "br", "img")
DAY = ("--date", "2026-03-31")


class Sheet(HTMLParser):
    """The tables and headings of a sheet; what it would fetch, run, or leave open."""

    def __init__(self, text):
        super().__init__()
        self.tables, self.heads, self.fetched, self.open, self.text = [], [], [], [], ""
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        """Note a tag."""
        self.fetched += [v for k, v in attrs if k in ("src", "href", "xlink:href", "data")]
        self.fetched += [k for k, _ in attrs if k.startswith("on")]
        self.fetched += [tag] * (tag in ("script", "link", "iframe", "img"))
        if tag not in UNTITLED:
            self.open.append(tag)
        if tag == "table":
            self.tables.append([])
        if tag == "tr":
            self.tables[-1].append([])
        if tag in ("td", "th"):
            self.tables[-1][-1].append("")

    def handle_startendtag(self, tag, attrs):
        """Note a tag that ends where it begins."""
        self.handle_starttag(tag, attrs)
        self.handle_endtag(tag)

    def handle_endtag(self, tag):
        """Note that a tag ends."""
        assert self.open.pop() == tag

    def handle_data(self, data):
        """Note text, and style sheets that would fetch something."""
        self.text += data
        inside = self.open[-1] if self.open else ""
        if inside == "style":
            self.fetched += re.findall(r"url\([^)]*\)|@import", data)
        if inside in ("td", "th"):
            self.tables[-1][-1][-1] += data
        if inside in ("h2", "h3"):
            self.heads.append(data)

    def column(self, first, name):
        """Return a column of the first table whose first column has a name, by the first."""
        table = next(t for t in self.tables if t[0][0] == first and name in t[0])
        return {row[0]: row[table[0].index(name)] for row in table[1:]}

    def fact(self, label):
        """Return the first fact of a label."""
        return next(row[1] for t in self.tables for row in t if row[0] == label)


@pytest.fixture
def sheet_of(run, tmp_path, monkeypatch):
    """Write the sheet of a file; return what is on it."""
    monkeypatch.setattr(asked, "APART", math.radians(30.0))
    for slow in ("plan", "forces_plan", "capability_diagram"):  # tested where they are at home
        monkeypatch.setattr(plot, slow, lambda *_, **__: Figure())

    def sheet_of(file, *options):
        page = tmp_path / "sheet.html"
        status, said, _ = run("report", file, page, *options)
        assert status == 0
        assert f"wrote {page}" in said
        return Sheet(page.read_text("utf-8"))

    return sheet_of


def close(told, value):
    """Tell whether a number told is a value, to the last digit that is told."""
    number = told.removesuffix(" %")
    last = 10.0 ** -len(number.partition(".")[2])
    return abs(float(number) - value) <= 0.501 * last


@pytest.mark.parametrize("name", ["deck-barge", "escort-ring", "supply-vessel"])
def test_all_numbers_are_those_of_the_library(name, sheet_of):
    """Quality before and after, each loss, the winds held, and the push forces."""
    sheet, scenario = sheet_of(name), load_example(name)
    assert [each for each in sheet.fetched if not each.startswith("#")] == []
    criterion, unit = scenario.criterion, FORCES[scenario.terms.force]
    (answer,) = place_sequence(scenario.problem(), 1)
    told = re.findall(r"[\d.]+", sheet.fact("Proven"))
    assert close(told[-1], answer.upper_bound / unit)
    swarm, word = answer.swarm_after, scenario.terms.robot
    lost = losses(swarm, load=criterion.load)
    name = scenario.terms.force.replace("tonne-force", "tf")
    shown = sheet.column("without", f"quality [{name}]")
    assert list(shown) == [loss.name for loss in lost]
    assert all(close(shown[loss.name], loss.quality / unit) for loss in lost)
    found = capability(swarm, scenario.environment, np.radians(np.arange(0, 360, 30)))
    winds = sheet.column("from [deg]", "intact [kn]")
    for bearing, wind in zip(found.bearings, found.intact / KNOT, strict=True):
        shown = winds[f"{np.degrees(bearing):.4g}"]
        assert shown == (">100" if wind >= 100 else f"{wind:.1f}")
    assert ("Push forces" in sheet.heads) == criterion.has_load
    if criterion.has_load:
        against = forces(swarm, (0, 0, 0), load=criterion.load)
        shares = sheet.column(word, "share")
        assert all(close(shares[robot.name], 100 * share)
                   for robot, share in zip(swarm, against.shares, strict=True))  # fmt: skip


def test_an_answer_file_is_checked_and_told_not_found_anew(run, sheet_of, tmp_path, monkeypatch):
    """The same sheet as of the scenario, but for what an answer file does not hold."""
    file, whole = tmp_path / "answer.json", sheet_of("hull-120")
    assert run("place", "hull-120", "--json", file)[0] == 0
    (stated,) = placements_in(json.loads(file.read_text()))
    monkeypatch.setattr("swarmgrasp.cli.place.solve", None)
    sheet = sheet_of(file)
    assert sheet.fact("Date of the answer") == json.loads(file.read_text())["date"][:10]
    assert sheet.fact("Proven") == whole.fact("Proven")
    assert sheet.column("place", "of best") == whole.column("place", "of best")
    assert "Answer: verified" in sheet.text
    assert f"best place for {stated.robot.name}" in sheet.text
    assert sheet.fact("SHA-256 of the question") == whole.fact("SHA-256 of the question")
    status, _, complaints = run("report", file, tmp_path / "windy.html", "--wind", "5kn", *DAY)
    assert status == 2
    assert "--wind asks another question" in complaints
    assert "--date is 2026-03-31, and" in complaints


def test_an_answer_that_does_not_hold_gets_no_sheet(run, tmp_path, pontoon):
    """Nothing is there to be signed."""
    file, page = tmp_path / "answer.json", tmp_path / "sheet.html"
    assert run("place", pontoon, "--json", file)[0] == 0
    document = json.loads(file.read_text())
    document["placements"][0]["quality"] *= 1.01
    file.write_text(json.dumps(document))
    status, said, complaints = run("report", file, page)
    assert (status, said, page.exists()) == (1, "", False)
    assert "the file was altered" in complaints
    assert "is not written" in complaints


def test_the_same_job_gives_the_same_bytes_and_markdown_the_same_tables(run, tmp_path, pontoon):
    """Also without a newcomer, and in another year of the program's clock."""
    pontoon.write_text(pontoon.read_text().partition("newcomer")[0])
    pages = []
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        page, text = tmp_path / folder / "s.html", tmp_path / folder / "s.md"
        assert run("report", pontoon, page, "--markdown", text, *DAY)[0] == 0
        pages.append({path.name: path.read_bytes() for path in page.parent.iterdir()})
    assert pages[0] == pages[1]
    assert set(pages[0]) == {"s.html", "s.md", "s-plan.svg"}
    sheet = Sheet(pages[0]["s.html"].decode())
    assert not {"Answer", "Check"} & set(sheet.heads)
    assert sheet.fact("Date of the answer") == "2026-03-31"
    lines = [line.replace("\\", "") for line in pages[0]["s.md"].decode().split("\n")]
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in lines if line.startswith("|") and "---" not in line]  # fmt: skip
    told = [row for table in sheet.tables for row in table]
    assert [row for row in rows if any(row)] == told


def test_no_name_plays_tricks(run, tmp_path, pontoon):
    """Names are text wherever they stand: in HTML, in its drawings, in Markdown."""
    bad = "</text></svg><script>x</script> ](http://a.b) <img src=x onerror=y> `|` $\\frac12$ &amp;"
    quoted = json.dumps(bad)
    text = pontoon.read_text().replace("name: Pontoon", f"name: {quoted}\ndescription: {quoted}")
    pontoon.write_text(text.replace("name: A,", f"name: {quoted},"))
    page, told = tmp_path / "s.html", tmp_path / "s.md"
    assert run("report", pontoon, page, "--markdown", told)[0] == 0
    sheet = Sheet(page.read_text("utf-8"))
    assert [each for each in sheet.fetched if not each.startswith("#")] == []
    assert sheet.text.count(bad) > 5
    assert "<script" not in told.read_text("utf-8")
    assert re.findall(r"(?<!\\)\]\((?!s-plan)", told.read_text("utf-8")) == []


def test_all_faults_come_at_once_and_nothing_is_half_written(run, tmp_path, pontoon, monkeypatch):
    """Of both files, the date, the weather and the scenario; and when Ctrl-C comes late."""
    status, _, complaints = run("report", tmp_path / "none.yaml", tmp_path / "s.txt", "--markdown",
                                tmp_path / "no" / "s.md", "--date", "31.3.2026",
                                "--wind", "5 parrots")  # fmt: skip
    assert status == 2
    assert len(complaints.strip().split("\n")) == 5

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "_quality", interrupted)
    page = tmp_path / "s.html"
    page.write_text("an earlier one")
    assert run("report", pontoon, page, "--markdown", tmp_path / "s.md")[0] == 130
    assert page.read_text() == "an earlier one"
    assert {path.name for path in tmp_path.iterdir()} == {"pontoon.yaml", "s.html"}
