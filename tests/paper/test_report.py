import re
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest
from matplotlib.figure import Figure

from swarmgrasp.pages import writing
from swarmgrasp.pages.page import Picture
from swarmgrasp.pages.runner import Runner, workers
from swarmgrasp.pages.statements import Statement
from swarmgrasp.paper import report, sections
from swarmgrasp.paper.measured import measure
from swarmgrasp.paper.sizes import FULL, QUICK, Size
from swarmgrasp.paper.studies.gains import gain_of
from swarmgrasp.paper.theory import THEORY

ROOT = Path(__file__).parent.parent.parent
SMALL = Size("small", 400, 10, (5, 15, 25), (50,), 1, 10, 12, 1000)
TINY = Size("tiny", 20, 2, (5, 10), (12,), 1, 2, 2, 50)


def test_every_statement_of_the_report_holds():
    """The report's own sentences and checks, on few draws; what hangs on times is left out."""
    found = measure(Runner(), SMALL, seed=1)
    assert len(found.every) > 30
    theory = (ROOT / "docs" / "theory.md").read_text("utf-8")
    assert all(f"**({label})**" in theory for label in THEORY)
    assert all(one.rests_on and {*one.rests_on} <= {*THEORY} for one in found.every)
    assert [one.text for one in found.every if not (one.holds or one.is_timing)] == []
    assert not any("nan" in one.text or "inf" in one.text for one in found.every)


class Page(HTMLParser):
    """Collects what a page refers to, and what it does not close."""

    def __init__(self):
        super().__init__()
        self.sources, self.names, self.open = [], set(), []

    def handle_starttag(self, tag, attrs):
        """Note a tag."""
        self.sources += [value for name, value in attrs if name in ("src", "href")]
        self.names |= {value for name, value in attrs if name == "id"}
        if tag not in ("meta", "img"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        """Note that a tag ends."""
        assert self.open.pop() == tag


def test_a_report_is_whole_and_refers_to_nothing_else(tmp_path, monkeypatch):
    """One HTML page with its pictures inside, Markdown with its pictures beside it."""
    false = Statement("Two and two are five & <more>.", holds=False)
    monkeypatch.setattr("swarmgrasp.paper.studies.construction.statements", lambda _: [false])
    monkeypatch.setattr(sys.modules["swarmgrasp.plot.save"], "PIXELS_PER_INCH", 30)
    for slow in ("plan", "wrench_sets"):  # tested where they are at home
        monkeypatch.setattr(sections, slow, lambda *_, **__: Figure())
    seen, folder = [], tmp_path / "new" / "report"
    written = report.write_report(folder, TINY, 1, progress=seen.append, in_processes=False)
    assert seen == sorted(seen)
    assert seen[-1] == report.report_steps(TINY)
    assert {path.name for path in written.paths} == {path.name for path in folder.iterdir()}
    assert false in written.failed
    page = (folder / "paper.html").read_text("utf-8")
    parser = Page()
    parser.feed(page)
    assert parser.open == []
    links = {source for source in parser.sources if source.startswith("#")}
    assert links == {f"#{name}" for name in parser.names}
    rest = {*parser.sources} - links
    assert all(source.startswith("data:image/png;base64,") for source in rest)
    assert "not so in this run:</b> Two and two are five &amp; &lt;more&gt;." in page
    text = (folder / "paper.md").read_text("utf-8")
    pictures = re.findall(r"\]\(([^)]+)\)", text)
    assert {*pictures} - links == {path.name for path in written.paths if path.suffix == ".png"}
    assert all(f'<a id="{link[1:]}"></a>' in text for link in links)
    assert "✗ not so in this run: Two and two are five &amp; &lt;more>." in text


def test_nothing_is_left_behind_when_it_fails(tmp_path, monkeypatch):
    """An earlier report stays as it was."""
    (tmp_path / "paper.html").write_text("an earlier one")

    def fail(*_):
        raise OSError("the disk is full")

    monkeypatch.setattr(report, "sections", lambda _: [Picture("a.png", Figure(), "A")])
    monkeypatch.setattr(writing, "save", fail)
    with pytest.raises(OSError, match="the disk is full"):
        report.write_report(tmp_path, TINY, 1, in_processes=False)
    assert [path.name for path in tmp_path.iterdir()] == ["paper.html"]
    assert (tmp_path / "paper.html").read_text() == "an earlier one"


def test_processes_find_the_same():
    """In the order of the draws."""
    tasks, seen = [(1, 5, k) for k in range(6)], []
    with workers() as executor:
        found = Runner(executor, seen.append).map(gain_of, tasks)
    assert found == [gain_of(task) for task in tasks]
    assert seen == [1, 2, 3, 4, 5, 6]


def test_the_sizes_are_what_is_promised():
    """At least a thousand draws for the pictures, five hundred for what the paper left out."""
    assert min(FULL.gains, QUICK.gains) >= 1000
    assert FULL.relaxed >= 500
    assert (FULL.timed, FULL.configurations) == (tuple(range(5, 26)), 10)
