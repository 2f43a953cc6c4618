"""Names are refused at the border when no terminal, picture or file could show them."""

from xml.dom import minidom

import pytest

from swarmgrasp import Newcomer, Outline, Robot, Stretch, SwarmGraspError, Zone
from swarmgrasp.cli import main
from swarmgrasp.scenario import example_text

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
CONTROLS = ["\x1b[31mred", "\x07", "two\u2028lines", "\ud800", "\uffff"]
HIDDEN = [
    "\u200bA",
    "A\u2060",
    "A\ufeffB",
    "so\xadft",
    "A\u200dB",
    "\u200d\u200d",
    "\ufe0fA",
    "A\U000e0041",
]
TURNED = ["\u202eA", "A\u200f", "\u2066A\u2069"]
BLANK = [" ", " \u3000\xa0", "\u2800", "\u3164", "\u0301"]


NAMED = pytest.mark.parametrize(
    "named",
    [
        lambda name: Robot((1, 0), 0.0, name=name),
        lambda name: Newcomer(name=name),
        lambda name: Zone(Stretch(0.0, 1.0, name)),
        lambda name: Outline(SQUARE, edge_names=["a", "b", "c", name]),
    ],
    ids=["robot", "newcomer", "stretch", "edge"],
)


@pytest.mark.parametrize("name", CONTROLS + HIDDEN + TURNED)
@NAMED
def test_a_name_with_a_character_that_is_not_seen_is_refused(named, name: str) -> None:
    """The message names the character, and holds none itself."""
    with pytest.raises(SwarmGraspError, match=r"holds U\+[0-9A-F]{4}") as caught:
        named(name)
    assert str(caught.value).isprintable()


@pytest.mark.parametrize("name", BLANK)
@NAMED
def test_a_blank_name_is_refused(named, name: str) -> None:
    """Of spaces, fillers, or marks without a letter."""
    with pytest.raises(SwarmGraspError, match="shows nothing; give it a letter"):
        named(name)


def test_every_other_name_is_taken() -> None:
    """Letters of any script, joined or not; spaces of any width; emoji joined, coloured, of flags.

    And no name at all.
    """
    england = "🏴" + "".join(chr(0xE0000 + ord(c)) for c in "gbeng") + "\U000e007f"
    scripts = [
        "Zoë",
        "Zoe\u0308",
        "拖轮 七",
        "\u0647\u200c\u0627",
        "क्\u200dष",
        "שלום",
        "$x$",
        "<b>&",
    ]
    for name in [
        *scripts,
        "tug\u00a0one",
        "👩\u200d🚒",
        "❤\ufe0f\u200d🔥",
        "👍🏽",
        "1\ufe0f\u20e3",
        england,
        "",
    ]:
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
