"""Notebooks show every object as a picture, and in the words of the command line."""

import html
import math
import re
import subprocess
import sys

import numpy as np
import pytest
from matplotlib.figure import Figure

import swarmgrasp as sg
from swarmgrasp.cli import main
from swarmgrasp.inline import html as page
from swarmgrasp.inline.html import MOST_DRAWN
from swarmgrasp.inline.pictures import draw
from swarmgrasp.inline.words import MOST_ROWS, words_of
from swarmgrasp.plain import Answer
from swarmgrasp.scenario import Scenario, load_example
from swarmgrasp.simulation import Run
from swarmgrasp.visible import Visible

RECTANGLE = load_example("rectangle-5")


def text_of(markup):
    """Return what a page says, without its picture and its style."""
    bare = re.sub(r"<(svg|style).*?</\1>", "", markup, flags=re.DOTALL)
    return " ".join(html.unescape(re.sub("<[^>]+>", " ", bare)).split())


def kinds(cls):
    """Yield all kinds of a kind."""
    for kind in cls.__subclasses__():
        yield kind
        yield from kinds(kind)


def test_every_kind_of_answer_has_a_picture_and_words():
    """A new one cannot be forgotten; what stands for others is never made itself."""
    shown = {
        kind for kind in kinds(Visible) if kind is not Answer and kind.__module__[:5] == "swarm"
    }
    assert {sg.Swarm, sg.Outline, sg.Problem, sg.Quality, Scenario, Run} <= shown
    bare = {k.__name__ for k in shown if {draw.dispatch(k), words_of.dispatch(k)} & BARE}
    assert bare == {"AllRound"}


BARE = {draw.dispatch(object), words_of.dispatch(object)}


@pytest.mark.parametrize(
    ("command", "ask"),
    [
        ("place", lambda: sg.place(RECTANGLE.problem(), runners_up=0.9)),
        ("place --robots 2", lambda: sg.place_sequence(RECTANGLE.problem(), 2, runners_up=0.9)),
        ("quality", lambda: RECTANGLE.swarm),
        ("move", lambda: sg.best_move(RECTANGLE.problem())),
        ("forces --wrench 0.1 0 0", lambda: sg.forces(RECTANGLE.swarm, (0.1, 0.0, 0.0))),
    ],
)
def test_a_notebook_says_what_the_command_says(command, ask, capsys, monkeypatch):
    """Line for line, but for the name of the scenario and for its file."""
    monkeypatch.setattr(page, "figure_of", lambda _: Figure())
    what, *options = command.split()
    assert main([what, "rectangle-5", "--units", "si", *options]) == 0
    said, printed = text_of(ask()._repr_html_()).lower(), capsys.readouterr().out
    printed = printed.removeprefix(f"{RECTANGLE.name}: ").replace(", as in the file", "")
    for line in printed.splitlines():
        if not line.startswith("All at once"):
            assert " ".join(line.split()).lower() in said


def test_units_and_words_of_the_file_are_those_of_the_scenario(monkeypatch):
    """A scenario is told in its own units and with its own word for robots."""
    monkeypatch.setattr(page, "figure_of", lambda _: Figure())
    said = text_of(load_example("deck-barge")._repr_html_())
    assert said.startswith("Deck barge")
    assert "5 tugs" in said
    assert "260.16 ft from corner to corner" in said


def test_a_name_is_no_markup():
    """Whatever it holds."""
    evil = "<script>alert(1)</script>"
    robot = sg.Robot((1.0, 0.2), math.pi, name=evil)
    markup = RECTANGLE.swarm.with_robot(robot)._repr_html_()
    assert "<script" not in markup
    assert "&lt;script&gt;" in markup


def test_pictures_on_one_page_do_not_share_their_parts():
    """Clip paths and arrows are found by name, all over a page."""
    pictures = [RECTANGLE.swarm.plot(title=title)._repr_svg_() for title in ("one", "other")]
    names = [set(re.findall(r'\bid="([^"]+)"', picture)) for picture in pictures]
    assert names[0]
    assert not names[0] & names[1]
    assert all("http" not in re.sub(r'xmlns(:\w+)?="[^"]+"', "", picture) for picture in pictures)


def test_a_crowd_is_told_in_few_rows_and_drawn_when_asked():
    """Ten thousand arrows would make no notebook lighter."""
    n = 10_000
    contacts = np.column_stack([np.linspace(-0.7, 0.7, n), np.full(n, 0.5)])
    outline = sg.Outline([(-0.75, -0.5), (0.75, -0.5), (0.75, 0.5), (-0.75, 0.5)])
    markup = sg.Swarm.from_arrays(outline, contacts, np.full(n, -1.0))._repr_html_()
    assert "<svg" not in markup
    assert f"More than {MOST_DRAWN} robots: plot() draws them." in markup
    assert f"The first {MOST_ROWS} robots are listed." in markup
    assert markup.count("<tr>") < MOST_ROWS + 20


def test_looking_at_the_package_draws_nothing():
    """Matplotlib is loaded when something is drawn, not before."""
    code = "import sys, swarmgrasp; sys.exit('matplotlib' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_verdict_says_what_it_refuses_and_what_it_took_on_trust():
    """Also where a fault quotes what a file says."""
    assert text_of(sg.Verdict(())._repr_html_()) == "Verified"
    trusted = sg.Verdict((), unchecked=("the bound",))._repr_html_()
    assert "Taken on trust: the bound." in trusted
    refused = sg.Verdict(("the place is <b>'x'</b>",), unchecked=("the bound",))._repr_html_()
    assert "Refused" in refused
    assert "the place is &lt;b&gt;" in refused
    assert "trust" not in refused
