"""Names are refused at the border when no terminal, picture or file could show them."""

from xml.dom import minidom

import pytest

from swarmgrasp import Newcomer, Outline, Robot, Stretch, SwarmGraspError, Zone
from swarmgrasp.cli import main
from swarmgrasp.scenario import example_text

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
ESCAPE, BELL, LINE, LONE, NOTHING = "\x1b[31mred", "\x07", "two\u2028lines", "\ud800", "\uffff"


@pytest.mark.parametrize("name", [ESCAPE, BELL, LINE, LONE, NOTHING])
@pytest.mark.parametrize(
    "named",
    [
        lambda name: Robot((1, 0), 0.0, name=name),
        lambda name: Newcomer(name=name),
        lambda name: Zone(Stretch(0.0, 1.0, name)),
        lambda name: Outline(SQUARE, edge_names=["a", "b", "c", name]),
    ],
    ids=["robot", "newcomer", "stretch", "edge"],
)
def test_a_name_with_a_control_character_is_refused(named, name: str) -> None:
    """The message shows the character escaped, and holds none itself."""
    with pytest.raises(SwarmGraspError, match="holds the control character") as caught:
        named(name)
    assert str(caught.value).isprintable()


def test_every_other_name_is_taken() -> None:
    """Letters of any script, spaces of any width, joined emoji."""
    for name in ("Zoë", "拖轮 七", "tug\u00a0one", "👩\u200d🚒", "$x$", "<b>&"):
        assert Robot((1, 0), 0.0, name=name).name == name


def test_pictures_of_odd_names_are_xml(tmp_path) -> None:
    """Angle brackets are escaped, and a file's own odd name is made plain."""
    scenario = tmp_path / "odd \x1b.yaml"
    text = example_text("supply-vessel")
    title = next(line for line in text.splitlines() if line.startswith("name:"))
    first = text.split("{name: ")[1].split(",")[0]
    scenario.write_text(text.replace(title, "").replace(f"name: {first},", 'name: "<b>&$x$",'))
    for command in (["plot"], ["capability", "--step", "60", "--plot"]):
        picture = tmp_path / f"{command[0]}.svg"
        named = [command[0], str(scenario), *command[1:], str(picture)]
        assert main(named) == 0
        minidom.parse(str(picture))
