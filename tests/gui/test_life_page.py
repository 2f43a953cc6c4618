"""Work is never lost: text, links, files, reloads, two windows, and a server that goes away."""

import json
import re

from swarmgrasp.gui.scenes import doc_of
from swarmgrasp.scenario import example_text, parse_scenario


def plain(problem):
    """Return a problem's plain form with numbers as they come back from a text."""
    return re.sub(r"-?\d+\.\d+(e-?\d+)?", lambda found: f"{float(found[0]):.9g}", repr(problem))


def test_a_saved_file_is_the_document_on_the_page(one):
    """What is saved, read by the library, is what was moved; the file's comments stay."""
    one.drag("[data-robot=Carina] .foot", -120, 0)
    text = one.download("Save as YAML").decode()
    kept = one.kept("escort-ring")["doc"]["problem"]
    assert plain(doc_of(parse_scenario(text)).problem) == plain(kept)
    assert "# Loaded tanker of 240 m" in text


def test_what_is_typed_is_drawn_and_faults_stand_at_their_line(one):
    """A typed limit moves the plan; a fault keeps the last answer and says line and column."""
    one.press("t")
    source = one.page.locator(".text-source")
    assert source.input_value() == example_text("escort-ring")
    text = example_text("escort-ring").replace("limit: 80", "limit: 75")
    source.fill(text)
    one.page.wait_for_selector(".label-new .below:text-matches('75')")
    one.rest()
    source.fill(text.replace("limit: 75", "limit: -75"))
    one.page.wait_for_selector(".text-fault")
    line = 1 + text[: text.index("limit: 75")].count("\n")
    assert one.text(".text-where").startswith(f"line {line}, column")
    assert "limit" in one.text(".text-fault")
    assert one.text(".label-new .below") == "75 t"
    one.click(".text-fault")
    assert one.page.evaluate("document.activeElement.selectionStart") >= text.index("limit: 75")
    source.fill(text)
    one.page.wait_for_selector(".text-fault", state="detached")
    one.press("Escape")
    one.press("Control+z")
    assert one.text(".label-new .below") == "80 t"


def test_a_link_carries_the_scenario_and_no_key(window):
    """A copied link opens the same document in a window that knows the key, and is then its own."""
    one = window(permissions=["clipboard-read", "clipboard-write"])
    one.drag("[data-robot=Carina] .foot", -120, 0)
    moved = one.robot("Carina")
    one.click("[aria-label='Copy a link to this']")
    one.page.wait_for_selector(".toast:has-text('copied')")
    link = one.page.evaluate("navigator.clipboard.readText()")
    assert "k" * 32 not in link
    assert "#s=" in link
    assert "k" * 32 not in one.page.url
    two = window(beside=one, at=link)
    assert two.robot("Carina") == moved
    assert "#" not in two.page.url
    two.drag("[data-robot=Carina] .foot", 60, 0)
    assert two.robot("Carina") != moved
    assert one.robot("Carina") == moved


def test_a_broken_link_says_so_and_opens_the_usual_scene(window, link):
    """A link that does not inflate is no reason for an empty page."""
    one = window(at=f"{link}&s=AAAA")
    assert one.text(".scene-title") == "Escort ring"
    assert "cannot be read" in one.text(".toast")


def test_a_reload_brings_changes_back_though_an_idle_window_is_open(window):
    """Each window removes only what it wrote; starting over is one step."""
    one = window()
    one.drag("[data-robot=Carina] .foot", -120, 0)
    moved = one.robot("Carina")
    idle = window(beside=one)
    idle.click(".toast button")
    assert idle.robot("Carina") != moved
    one.page.bring_to_front()
    one.drag("[data-robot=Dufa] .foot", -60, 0)
    idle.page.close()
    one.page.reload()
    one.rest()
    assert one.robot("Carina") == moved
    one.click(".toast button")
    assert one.robot("Carina") != moved
    one.press("Control+z")
    assert one.robot("Carina") == moved


def test_a_server_that_comes_back_finds_everything_still_there(window, comes_and_goes):
    """While it is away the page says so and goes on moving; then the newest is answered."""
    one = window(at=comes_and_goes.link)
    comes_and_goes.end()
    one.page.wait_for_selector(".banner:not([hidden])")
    assert "Everything here is kept" in one.text(".banner")
    one.focus("[data-robot=Carina]")
    one.page.keyboard.press("ArrowLeft")
    one.page.keyboard.press("0")
    comes_and_goes.begin()
    one.page.dispatch_event(".banner button", "click")  # hidden, if the page was quicker
    one.page.wait_for_selector(".banner[hidden]", state="attached")
    one.rest()
    assert one.kept("escort-ring")["doc"]["problem"]["criterion"]["losing"] == 0
    assert "with all nine working" in one.text(".answer")


def test_a_line_that_falls_while_a_scene_is_opened_opens_it_once(window):
    """What was asked is asked again, and not twice: the second would begin the history anew."""
    opened = []

    def tap(line):
        server = line.connect_to_server()

        def up(frame):
            message = json.loads(frame)
            if message["kind"] == "open":
                opened.append(message["n"])
                if len(opened) == 1:
                    line.close(code=1011)
                    return
            server.send(frame)

        line.on_message(up)

    one = window(lambda page: page.route_web_socket("**/ws", tap))
    assert one.text(".scene-title") == "Escort ring"
    assert opened == [1, 1]


def test_pictures_and_the_report_stand_by_themselves(one):
    """The SVG needs no page around it, the PNG is twice as large, the report is a sheet."""
    drawing = one.download("Picture, SVG").decode()
    assert drawing.startswith("<svg")
    assert "Idunn" in drawing
    assert not re.search(r"var\(|color\(|style=|class=|light-dark", drawing)
    png = one.download("Picture, PNG")
    assert png[:4] == b"\x89PNG"
    assert int.from_bytes(png[16:20]) == 2 * int(re.search(r'width="(\d+)"', drawing)[1])
    report = one.download("Report, HTML").decode()
    assert "<html" in report
    assert "Idunn" in report
