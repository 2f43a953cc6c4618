"""The views beside the plan: they show what the library says, and mark what another points at."""

import re

import numpy as np
import pytest

from swarmgrasp import capability, losses, place
from swarmgrasp.scenario import load_example

axe = pytest.importorskip("axe_playwright_python.sync_playwright")
expect = pytest.importorskip("playwright.sync_api").expect

KNOT, TONNE = 1852 / 3600, 9806.65
TAGS = ["wcag2a", "wcag2aa", "wcag21aa", "wcag22aa", "best-practice"]
WIDE, PHONE = {"width": 1440, "height": 900}, {"width": 390, "height": 844}
MARKED = "one => one.classList.contains('hovered') || one.hasAttribute('data-hovered')"


def is_marked(window, selector):
    """Tell whether an element is marked because another view points at it."""
    return window.page.locator(selector).first.evaluate(MARKED)


def picture(window, name):
    """Return what a canvas shows."""
    return window.page.locator(f"canvas.{name}").evaluate("one => one.toDataURL()")


def wind(window):
    """Return the sentence of the wind's handle."""
    return window.page.locator(".rose-wind").get_attribute("aria-valuetext").replace("\u00a0", " ")


def test_figures_are_those_of_the_library(window):
    """Verdict, losses, and the wind that is held from the wind's bearing, in the file's units."""
    one, scenario = window(), load_example("escort-ring")
    answer = place(scenario.problem())
    swarm, criterion = answer.swarm_after, scenario.criterion
    rows = losses(swarm, **{**criterion.keywords, "losing": criterion.losing - 1})
    said = one.page.locator(".bar-row").evaluate_all(
        "rows => rows.map(row => [row.dataset.name, row.children[2].textContent])"
    )
    assert said == [[row.name, f"{row.quality / TONNE:.0f}"] for row in rows]
    after = one.page.locator(".figures .after").first.text_content()
    assert after == f"{answer.quality / TONNE:.0f}"
    bearing = np.array([scenario.environment.wind.bearing])
    held = capability(swarm, scenario.environment, bearing, criterion.losing).after_loss[0]
    assert wind(one) == f"35 kn from 060°; held from there up to {held / KNOT:.0f} kn"


def test_a_row_points_at_its_robot_everywhere(one):
    """In the plan, among the facts and on the body; a click chooses it, and another lets it go."""
    before = picture(one, "body")
    row = ".bar-row[data-name='Brimir']"
    one.hover(row)
    assert is_marked(one, ".robot[data-robot='Brimir']")
    assert is_marked(one, ".fact[data-mark='weakest']")
    assert picture(one, "body") != before
    one.hover(".first")
    assert not is_marked(one, ".robot[data-robot='Brimir']")
    assert picture(one, "body") == before
    one.click(row)
    assert one.page.locator(row).get_attribute("aria-pressed") == "true"
    one.click(row)
    assert one.page.locator(row).get_attribute("aria-pressed") == "false"
    one.page.mouse.move(0, 0)
    one.focus(".robot[data-robot='Brimir']")
    assert is_marked(one, row)
    assert picture(one, "body") != before
    one.press("h")  # other rows in another order
    marked = one.page.locator(".bar-row[data-hovered]")
    assert [one.text(".bar-row[data-hovered] .bar-name"), marked.count()] == ["Brimir", 1]


def test_a_place_of_the_map_stands_in_the_plan(one):
    """By hand, by keys with a sentence, and from the next best; Escape lets it go."""
    spoken = one.page.locator(".spoken")
    expect(spoken).to_contain_text("Held in ")  # the answer is spoken once, after a while
    ghost = one.page.locator(".ghost")
    one.hover(".next li >> nth=1")
    assert ghost.is_visible()
    one.hover(".first")
    assert not ghost.is_visible()
    one.focus(".landscape")
    one.press("ArrowUp")
    assert ghost.is_visible()
    expect(spoken).to_have_text(re.compile("^starboard fore bollard, \u2212\\d° off square: 34.t$"))
    one.press("ArrowLeft")
    expect(spoken).to_contain_text("starboard aft bollard, ")
    one.press("Escape")
    assert not ghost.is_visible()


def test_the_wind_is_a_handle(one):
    """Dragged past what is held it turns the verdict; one undo brings all of the drag back."""
    first = one.text(".first")
    one.drag(".rose-wind", 42, -20)
    assert one.text(".tile-wrench .tile-aside") == "not held"
    assert one.text(".first.bad").startswith("Not held in ")
    assert one.text(".second").startswith("at most ")
    one.press("Control+z")
    assert one.text(".first.good") == first
    one.focus(".rose-wind")
    one.press("ArrowUp", "Shift+ArrowRight")
    assert one.text(".first") == "Held in 36 kn from 070°"
    assert wind(one).startswith("36 kn from 070°; ")


def test_the_body_turns_under_hand_and_keys(one):
    """And Home brings the first look back."""
    before = picture(one, "body")
    one.focus(".body")
    one.press("ArrowLeft")
    assert picture(one, "body") != before
    one.press("Home")
    assert picture(one, "body") == before
    one.drag(".body", 40, 10)
    assert picture(one, "body") != before


def test_a_phone_draws_the_answer_up(window):
    """The views lie under tabs; nothing is wider than the screen."""
    one = window(viewport=PHONE, has_touch=True)
    drawer = one.page.locator(".drawer")
    low = drawer.bounding_box()["height"]
    one.tap(".grip")
    assert drawer.bounding_box()["height"] > 2 * low
    one.tap(".tab:text-is('Wind held')")
    assert one.page.locator(".rose").is_visible()
    assert not one.page.locator(".body").is_visible()
    assert one.page.evaluate("document.documentElement.scrollWidth - innerWidth") == 0


LOOKS = [
    (WIDE, "dark"),
    pytest.param(WIDE, "light", marks=pytest.mark.long),
    pytest.param(PHONE, "dark", marks=pytest.mark.long),
    pytest.param(PHONE, "light", marks=pytest.mark.long),
]


@pytest.mark.parametrize(("viewport", "theme"), LOOKS)
def test_nothing_keeps_people_out(window, viewport, theme):
    """On a wide screen and on a phone, in either theme: contrast, names, roles, targets."""
    one = window(viewport=viewport, color_scheme=theme, bypass_csp=True)
    found = axe.Axe().run(one.page, options={"runOnly": TAGS}).response["violations"]
    assert [(each["id"], [node["html"] for node in each["nodes"]]) for each in found] == []
