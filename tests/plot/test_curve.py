"""The curve's picture."""

from swarmgrasp.agents.knowledge import Case, Size, measure
from swarmgrasp.agents.knowledge.cases import BARGE, FREE, PUSH, STEER
from swarmgrasp.plot.curve import knowledge_curve


def test_a_line_for_each_knowledge():
    """The median of all at its row, those of each kind, and bounds only where there are any."""
    cases = [Case(BARGE, kind, 3, 5) for kind in (PUSH, FREE, STEER)]
    curve = measure(Size("tiny", dict.fromkeys(cases, 1)), 4)
    left, right = knowledge_curve(curve).axes
    lines = curve.every.lines[::-1]
    assert [label.get_text() for label in left.get_yticklabels()] == [line.known for line in lines]
    drawn = {line.get_label(): line for line in left.lines}
    assert drawn["median of all"].get_xdata().tolist() == [line.median for line in lines]
    steer = curve.kind(STEER)
    assert drawn["median, steer"].get_xdata().tolist() == [line.median for line in steer.lines]
    short, most = right.lines
    judged = [line for line in lines if line.decisions]
    assert short.get_xdata().tolist() == [line.regret for line in judged]
    assert most.get_xdata().tolist() == [line.bound for line in judged]
