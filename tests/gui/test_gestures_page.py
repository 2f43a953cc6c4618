"""Hands on the page: each gesture does what it says, is one step, and can be undone."""

import math

from swarmgrasp import place, place_sequence
from swarmgrasp.scenario import load_example

ORIGINS = "escort-ring"


def test_a_dragged_robot_stays_on_the_outline_and_is_one_step(one):
    """A tug dragged away from the hull slides along it; undo and redo take the whole gesture."""
    before = one.robot("Carina")
    one.drag("[data-robot=Carina] .foot", -120, 40)
    moved = one.robot("Carina")
    contact = one.kept(ORIGINS)["doc"]["problem"]["swarm"]["robots"][2]["contact"]
    assert "on starboard side" in moved
    assert moved != before
    assert contact[1] == -21.0
    assert one.text("[aria-label='How far along its side']").endswith("m along")
    one.press("Control+z")
    assert one.robot("Carina") == before
    assert one.kept(ORIGINS) is None
    one.press("Control+Shift+Z")
    assert one.robot("Carina") == moved


def test_the_round_handle_turns_and_with_alt_changes_the_limit(one):
    """The handle turns in fives with Shift; with Alt it pulls the limit by whole units."""
    one.focus("[data-robot=Dufa]")
    one.drag(".knob-turn .grab", 30, 10, keys=["Shift"])
    turned = one.kept(ORIGINS)["doc"]["problem"]["swarm"]["robots"][3]
    assert turned["direction"] != 1.2217304763960306
    assert "off square" in one.robot("Dufa")
    one.drag(".knob-turn .grab", 0, -12, keys=["Alt"])
    limit = one.kept(ORIGINS)["doc"]["problem"]["swarm"]["robots"][3]["limit"] / 9806.65
    assert limit > 65.0
    assert abs(limit - round(limit)) < 1e-9


def test_keys_alone_do_all_that_hands_do(one):
    """From the address bar: walk, move, turn, strengthen, flip, add, remove, and undo it all."""
    for _ in range(30):
        one.page.keyboard.press("Tab")
        if one.page.evaluate("document.activeElement.closest('.robot') !== null"):
            break
    assert one.page.evaluate("document.activeElement.dataset.robot") == "Aegir"
    one.press(".", ".")
    assert one.page.evaluate("document.activeElement.dataset.robot") == "Carina"
    one.press("ArrowRight", "Shift+ArrowRight", "]", "Shift+[", "+", "f", "d", "Delete", "a", "a")
    kept = one.kept(ORIGINS)["doc"]["problem"]["swarm"]["robots"]
    assert [robot["name"] for robot in kept][-2:] == ["Tug 9", "Tug 10"]
    assert abs(kept[2]["contact"][0] - 81.0) < 0.5
    assert abs(kept[2]["limit"] / 9806.65 - 66.0) < 1e-9
    one.press(*10 * ["Control+z"])
    assert one.kept(ORIGINS) is None


def test_escape_leaves_a_gesture_as_if_it_had_not_been(one):
    """Escape while the hand still holds a tug puts it back."""
    before = one.robot("Carina")
    x, y = one.middle("[data-robot=Carina] .foot")
    one.page.mouse.move(x, y)
    one.page.mouse.down()
    one.page.mouse.move(x - 90, y, steps=4)
    one.press("Escape")
    one.page.mouse.up()
    one.rest()
    assert one.robot("Carina") == before
    assert one.kept(ORIGINS) is None


def test_a_key_beside_a_hand_does_not_end_its_gesture(one):
    """Shift pressed and let go while the wind is dragged: one step all the same."""
    x, y = one.middle(".rose-wind")
    one.page.mouse.move(x, y)
    one.page.mouse.down()
    one.page.mouse.move(x + 10, y + 10, steps=3)
    one.rest().page.keyboard.press("Shift")
    one.page.mouse.move(x + 20, y + 20, steps=3)
    one.page.mouse.up()
    assert one.rest().kept(ORIGINS) is not None
    one.press("Control+z")
    assert one.kept(ORIGINS) is None


def test_what_if_is_asked_by_numbers_that_are_typed_stepped_and_dragged(one):
    """Losses by a key, wind by typing, its bearing by arrows, a limit by dragging."""
    one.press("0")
    one.spin("Speed of the wind", 20)
    one.focus("[aria-label='Where the wind comes from']")
    one.press("ArrowUp", "Shift+ArrowUp")
    one.drag("[aria-label='Limit of Idunn']", 36, 0)
    one.click(".word:text-is('poses exact')")
    doc = one.kept(ORIGINS)["doc"]
    wind, criterion = doc["environment"]["wind"], doc["problem"]["criterion"]
    assert criterion["losing"] == 0
    assert criterion["worst_case"]
    assert abs(wind["speed"] - 20 * 0.514444444444) < 1e-6
    assert abs(wind["bearing"] - 1.2391837689159739) < 1e-9
    assert abs(doc["problem"]["newcomer"]["limit"] / 9806.65 - 86.0) < 1e-9
    assert one.text("h1.first, .answer h1").startswith(("Held in 20 kn from 071", "Not held"))
    one.press("w")
    assert not one.kept(ORIGINS)["doc"]["in_weather"]


def test_the_newcomer_is_kept_and_the_next_is_asked(one):
    """N takes the newcomer, Enter makes it a robot where it was best, and another one comes."""
    one.press("n", "Enter")
    problem = one.kept(ORIGINS)["doc"]["problem"]
    assert problem["swarm"]["robots"][-1]["name"] == "Idunn"
    assert problem["swarm"]["robots"][-1]["contact"] == [40.0, -21.0]
    assert problem["newcomer"]["name"] == "Idunn 2"


def test_the_newcomer_goes_where_another_place_is_told(one):
    """A click on the second of the next best makes it a robot there, in one step."""
    row = ".next li >> nth=1"
    other = place(load_example(ORIGINS).problem(), runners_up=0.0).runners_up[1]
    assert one.text(f"{row} >> .place") == other.place
    one.focus(f"{row} >> button")
    assert one.page.locator(".ghost").is_visible()
    one.press("Enter")
    problem = one.kept(ORIGINS)["doc"]["problem"]
    assert problem["newcomer"]["name"] == "Idunn 2"
    assert problem["swarm"]["robots"][-1]["contact"] == list(other.robot.contact)
    one.press("Control+z")
    assert one.kept(ORIGINS) is None


def test_a_thruster_is_dragged_within_the_hull(one):
    """A mounted one goes where the hand goes, but not out of the hull; keys and numbers move it."""
    one.open("Drillship thrusters")
    name = one.page.locator(".robot").first.get_attribute("data-robot")

    def contact():
        return one.kept("drillship-thrusters")["doc"]["problem"]["swarm"]["robots"][0]["contact"]

    one.drag(f"[data-robot='{name}'] .foot", -30, 0)
    x, y = contact()
    one.press("ArrowLeft")
    assert contact()[0] < x
    assert abs(contact()[1] - y) < 1e-9
    one.spin("Second coordinate", 0.05)
    assert abs(contact()[1] - 0.05) < 1e-9
    one.drag(f"[data-robot='{name}'] .foot", 0, -400)
    vertices = load_example("drillship-thrusters").swarm.outline.vertices
    assert contact()[1] <= max(y for _, y in vertices) + 1e-9
    assert one.page.locator("#studio.is-refused").count() == 0


def test_what_a_tug_steers_is_a_handle_on_either_side(one):
    """Dragged in fives with Shift, by keys, and as a number; at most all round."""
    one.open("Harbour tugs")
    one.focus("[data-robot=Ajax]")

    def steers():
        doc = one.kept("harbour-tugs")["doc"]
        return math.degrees(doc["problem"]["swarm"]["robots"][0]["steers"])

    assert one.page.locator(".knob-sector").count() == 2
    one.drag(".knob-sector >> nth=0 >> .grab", 30, 0, keys=["Shift"])
    assert steers() != 30.0
    assert abs(steers() % 5) < 1e-9 or abs(steers() % 5 - 5) < 1e-9
    one.spin("How far it steers either side", 20)
    one.focus(".knob-sector >> nth=0")
    one.press("ArrowUp")
    assert abs(steers() - 21.0) < 1e-9
    one.spin("How far it steers either side", 180)
    assert one.page.locator(".knob-sector").count() == 0


def test_a_finger_drags_as_a_mouse_does(window):
    """On a phone: a tug along its side, the wind on its rose, and taps that choose and let go."""
    one = window(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    before = one.robot("Carina")
    one.swipe("[data-robot=Carina] .foot", 0, 60)
    moved = one.robot("Carina")
    assert moved != before
    assert "on starboard side" in moved
    assert one.page.locator(".inspect").first.is_visible()
    one.tap(".origin")
    assert not one.page.locator(".inspect").first.is_visible()
    one.tap(".grip")
    one.tap(".tab:text-is('Wind held')")
    first = one.text(".first")
    one.swipe(".rose-wind", 30, -14)
    assert one.text(".first") != first
    assert one.page.evaluate("scrollY") == 0


def test_more_of_a_robot_is_told_in_numbers_and_words(one):
    """Tolerance, body and group of a tug; gaps of a thruster, which stay clear of each other."""
    one.focus("[data-robot=Carina]")
    one.press("m")
    one.spin("How far along the outline it may be", 2)
    one.spin("Length of its body, away from the outline", 20)
    one.page.fill(".more-group", "west")
    one.press("Enter")
    carina = one.kept(ORIGINS)["doc"]["problem"]["swarm"]["robots"][2]
    assert carina["tolerance"]["contact"] == [-2.0, 2.0]
    assert carina["body"] == {"length": 20.0, "beam": 8.0}
    assert carina["group"] == "west"
    assert one.page.locator("#studio.is-refused").count() == 0
    one.open("Drillship azimuths")
    one.press(".")
    one.click("button:text-is('Add a gap')")
    one.spin("Start of gap 1", 350)
    one.spin("End of gap 1", 10)
    bow = one.kept("drillship-azimuths")["doc"]["problem"]["swarm"]["robots"][0]
    ((start, end),) = bow["sectors"]
    assert bow["steers"] == 0.0
    assert abs(end - start - math.radians(340)) < 1e-9
    assert abs(math.remainder(start - math.radians(10), math.tau)) < 1e-9
    assert one.page.locator("#studio.is-refused").count() == 0


def test_zones_and_corners_are_moved_and_robots_go_with_their_side(one):
    """An end of a pad is dragged, and a corner of the hull moved by keys."""
    one.open("Deck barge")
    one.press("z")
    one.drag("[aria-label='End of port aft pads'] .grab", 60, 0)
    end = one.kept("deck-barge")["doc"]["problem"]["zones"][3]["stretch"]["end"]
    assert end < 163.0
    one.press("z")
    one.focus("[aria-label='Corner 1 of the outline']")
    one.press("Shift+ArrowLeft")
    doc = one.kept("deck-barge")["doc"]["problem"]
    assert abs(doc["swarm"]["outline"]["vertices"][0][0] + 38.1 + 3.048) < 1e-9
    assert one.page.locator("#studio.is-refused").count() == 0
    one.press("Control+z", "Control+z")
    assert one.kept("deck-barge") is None


def test_zones_are_drawn_by_hand(one):
    """Along the outline a zone, with Shift a no-go; inside an area, for who is mounted."""
    one.open("Deck barge")
    before = one.page.locator(".strip").count()
    one.press("z")
    side = one.page.locator(".hull").bounding_box()
    x, y = side["x"] + 0.4 * side["width"], side["y"] + side["height"]
    one.pull(x, y, 60, 0)
    one.pull(x, y - side["height"], 40, 0, keys=["Shift"])
    problem = one.kept("deck-barge")["doc"]["problem"]
    zone, no_go = problem["zones"][-1], problem["no_go"][-1]
    assert (zone["name"], no_go["name"]) == ("zone 1", "no-go 1")
    stretch = zone["stretch"]
    assert 0.0 < stretch["end"] - stretch["start"] < 20.0
    assert one.page.locator(".strip").count() > before
    one.press("Control+z", "Control+z")
    assert one.kept("deck-barge") is None
    one.open("Drillship azimuths")
    one.press("z")
    x, y = one.middle(".hull")
    one.pull(x, y, 50, 20)
    area = one.kept("drillship-azimuths")["doc"]["problem"]["zones"][-1]["area"]
    assert len(area) == 4
    assert one.page.locator("[aria-label^='Corner 3 of area 1']").count() == 1
    assert one.page.locator("#studio.is-refused").count() == 0


def test_what_the_library_refuses_is_said_and_the_last_answer_stays(one):
    """A limit below the least that its tolerance allows is refused in words, until it is undone."""
    before = one.text(".answer h1")
    one.focus("[data-robot=Carina]")
    one.spin("Limit", 10)
    assert one.page.locator("#studio.is-refused").count() == 1
    assert "least" in one.text(".answer")
    assert before in one.text(".answer")
    one.press("Control+z")
    assert one.page.locator("#studio.is-refused").count() == 0


def test_a_wanted_wrench_is_dragged_and_shared_out(one):
    """The arrow in the middle is pulled out; who gives how much stands beside each name."""
    one.press("h")
    assert one.page.locator(".push-words").is_visible()
    assert one.page.locator(".label .below:text-matches('% of')").count() > 0
    assert "%" in one.text(".push-words")
    one.drag(".knob-force .grab", 120, 0)
    assert "out of reach" in one.text(".push-words.unreached")
    one.press("Escape")
    assert one.page.locator(".push-words:not([hidden])").count() == 0


def test_several_newcomers_are_placed_one_by_one_and_together(one):
    """How many more come is asked in the bar; they stand in the plan."""
    one.open("Rectangle, 5 robots")
    one.click("[aria-label='How many more come after it']")
    one.click("[aria-label='How many more come after it']")
    assert one.page.locator(".newcomer.later").count() == 2
    problem = load_example("rectangle-5").problem()
    told = [f"{found.robot.name} → {found.place}" for found in place_sequence(problem, 3)[1:]]
    assert one.page.locator(".later-orders li").count() == 2
    for row, words in enumerate(told):
        assert one.text(f".later-go >> nth={row}").startswith(words)
    one.click(".word:text-is('one by one')")
    assert one.page.locator(".word:text-is('together')").count() == 1
    assert one.page.locator(".later-orders li").count() == 3
    assert one.page.locator(".newcomer.later").count() == 2
