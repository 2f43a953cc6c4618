"""Final quality against what is communicated."""

import json
from statistics import median

import numpy as np
import pytest
from matplotlib.figure import Figure

from swarmgrasp.agents.knowledge import QUICK, Case, Size, measure, tasks_of
from swarmgrasp.agents.knowledge.beliefs import ALL, KNOWN, NOTHING, SIGHT, WORST, known_in, nearest
from swarmgrasp.agents.knowledge.cases import BARGE, FREE, PUSH, STEER, TANK
from swarmgrasp.agents.knowledge.growing import grow
from swarmgrasp.pages import curve as page
from swarmgrasp.pages.runner import Runner

CASES = Case(BARGE, PUSH, 3, 5), Case(TANK, FREE, 3, 5), Case(BARGE, STEER, 3, 5)
TINY = Size("tiny", {CASES[0]: 2, CASES[1]: 1, CASES[2]: 1})


@pytest.fixture(scope="module")
def curve():
    """Measure on a few swarms."""
    return measure(TINY, 2)


def test_lines_sum_up_what_grew(curve):
    """Shares of the quality with everything known, over each case, kind and all."""
    found = [grow(task) for task in tasks_of(TINY, 2)]
    assert [lines.of for lines in curve.cases] == [case.words for case in CASES]
    first = curve.cases[0]
    shares = [each[NOTHING].quality / each[ALL].quality for each in found[:2]]
    assert first[NOTHING].median == pytest.approx(median(shares))
    assert first.quality == pytest.approx(median(each[ALL].quality for each in found[:2]))
    assert curve.every[NOTHING].draws == 4
    regrets = [r for each in found for r in each[NOTHING].regrets]
    assert curve.every[NOTHING].decisions == len(regrets) == 8
    assert curve.every[NOTHING].regret == pytest.approx(np.mean(regrets))
    assert (curve.every[ALL].low, curve.every[ALL].high) == (1.0, 1.0)
    assert WORST in curve.kind(PUSH)
    assert WORST not in curve.kind(FREE)
    assert all(line.broken == 0 for line in curve.every.lines)


def test_the_same_seed_gives_the_same_curve(curve):
    """As plain data, whatever ran where; another seed another one."""
    one = Size("tiny", {CASES[0]: 2})
    again = measure(one, 2, lambda work, tasks: [work(task) for task in tasks])
    assert json.dumps(again.cases[0].to_data()) == json.dumps(curve.cases[0].to_data())
    assert measure(Size("tiny", {CASES[0]: 1}), 3).cases != curve.cases[:1]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.words)
def test_what_is_known(case):
    """Each knowledge is of robots that are there, or of as many; nearest are nearest."""
    rng = np.random.default_rng(1)
    swarm = case.start(rng)
    assert set(known_in(case)) <= set(KNOWN)
    assert KNOWN[ALL](case, swarm, rng) is swarm
    assert len(KNOWN[nearest(2)](case, swarm, rng)) == 2
    seen = KNOWN[SIGHT](case, swarm, rng)
    assert seen.contacts.tolist() == swarm.contacts.tolist()
    if case.kind == STEER:  # a place tells all
        assert seen.directions == pytest.approx(swarm.directions)
        assert seen.steers.tolist() == swarm.steers.tolist()


def test_a_page_is_written_with_its_picture(curve, tmp_path, monkeypatch):
    """Every sentence is told with its check; the picture is made of the curve."""
    monkeypatch.setattr(page, "measure", lambda *_: curve)
    drawn = []
    monkeypatch.setattr(page, "knowledge_curve", lambda c: drawn.append(c) or Figure())
    seen = []
    written, measured = page.write_curve(
        tmp_path, TINY, 2, progress=seen.append, in_processes=False
    )
    assert measured is curve
    assert drawn == [curve]
    assert {path.name for path in written.paths} == {
        "communication.html", "communication.md", "communication.png"
    }  # fmt: skip
    text = (tmp_path / "communication.md").read_text("utf-8")
    assert all(one.text.split(":")[0].replace("_", "\\_") in text for one in written.statements)
    assert "This is a tiny run" in text
    assert "nan" not in text


@pytest.mark.long
def test_every_statement_of_a_quick_run_holds():
    """The page's own sentences and checks."""
    said = page.statements(measure(QUICK, 1, Runner().map))
    assert [one.text for group in said.values() for one in group if not one.holds] == []
