"""The pictures of studies."""

import pytest

import swarmgrasp as sg
from swarmgrasp.plot import study_picture
from swarmgrasp.plot.study import KINDS
from swarmgrasp.simulation.study import KINDS as STUDIES
from swarmgrasp.simulation.study import ColumnHead, Findings, Gathered, Losses, Plan, Sizes


@pytest.fixture
def found(barge):
    """Return what a study has found, of such rows."""
    problem = sg.Problem(barge, sg.Newcomer(1.0, "push", 0.5))

    def found(kind, rows):
        plan = Plan("Barge", kind(problem), 10, 1, 10, "0.1.0", "")
        headings = tuple(ColumnHead("") for _ in rows[0])
        return Gathered(plan, 10, 0, (), "", Findings("", headings, tuple(rows)))

    return found


def test_every_kind_has_a_picture():
    """And there is none of another."""
    assert KINDS.keys() == STUDIES.keys()


def test_qualities_are_drawn_in_one_unit(found):
    """Shares on the left, quantiles on the right."""
    rows = [(4, 5, 0.2, 0.0, 500.0, 1000.0), (6, 5, 0.6, 100.0, 900.0, 2000.0)]
    left, right = study_picture(found(Sizes, rows)).axes
    assert left.lines[0].get_xydata().tolist() == [[4.0, 0.2], [6.0, 0.6]]
    assert right.lines[0].get_xydata().tolist() == [[4.0, 0.5], [6.0, 0.9]]
    assert right.get_ylabel() == "quality [kN]"


def test_what_there_is_nothing_to_tell_of_is_left_out(found):
    """A gap in the line."""
    rows = [(5, 5, 0.0, 0.0, float("nan"), float("nan")), (6, 5, 0.6, 0.1, 1.5, 0.3)]
    figure = study_picture(found(Losses, rows))
    left, right = figure.axes
    assert [line.get_label() for line in left.lines] == ["as they are", "after any one loss"]
    assert right.lines[0].get_ydata()[1] == 0.3
    assert len(figure.legends) == 1
