"""What is measured on the plans of every built-in example, as wide as a page and as a column."""

import itertools

import pytest
from matplotlib.text import Text

from swarmgrasp.plot import plan
from swarmgrasp.quality import quality
from swarmgrasp.scenario import example_names, load_example

COLUMN, PAGE = 88.0 / 25.4, 5.2
CASES = [
    *((name, COLUMN) for name in example_names()),
    *((name, PAGE) for name in ("deck-barge", "rectangle-15")),
    *(pytest.param(name, PAGE, marks=pytest.mark.long) for name in example_names()),
]


def written(figure):
    """Return every text that is drawn, with the box it fills."""
    figure.draw_without_rendering()
    away = set()
    for axis in (axis for ax in figure.axes for axis in (ax.xaxis, ax.yaxis)):
        low, high = sorted(axis.get_view_interval())
        for tick in axis.get_major_ticks():
            away |= set() if low <= tick.get_loc() <= high else {tick.label1}
    texts = [text for text in figure.findobj(Text) if text.get_text().strip() and text not in away]
    return [(text, text.get_window_extent()) for text in texts if text.get_visible()]


@pytest.mark.parametrize(("name", "width"), CASES)
def test_no_text_lies_on_another(name, width):
    """Nor beyond the page; none is too small for print, and the scenario's name is the title."""
    scenario = load_example(name)
    figure = plan(
        scenario.swarm, quality=quality(scenario.swarm, load=scenario.criterion.load),
        zones=scenario.zones or (), no_go=scenario.no_go, environment=scenario.environment,
        terms=scenario.terms, title=scenario.name, width=width,
    )  # fmt: skip
    boxes = written(figure)
    for (one, here), (other, there) in itertools.combinations(boxes, 2):
        assert not here.overlaps(there), (one.get_text(), other.get_text())
    for text, box in boxes:
        assert figure.bbox.padded(0.5).contains(*box.min), text.get_text()
        assert figure.bbox.padded(0.5).contains(*box.max), text.get_text()
        assert text.get_fontsize() >= (5.2 if text.get_gid() == "tag" else 5.6) - 1e-9
    assert scenario.name in [text.get_text() for text, _ in boxes]
