import json
import math
import re

import pytest

from swarmgrasp import capability_numbers, place_for_capability, thrust_use
from swarmgrasp.environment import KNOT
from swarmgrasp.scenario import load_example, load_scenario

PONTOON = """\
name: Pontoon
outline: {vertices: [[-2, -1], [2, -1], [2, 1], [-2, 1]], edges: [starboard, bow, port, stern]}
robots:
  - {name: A, edge: starboard, along: 0.5, direction: inward, limit: 1000}
  - {name: B, edge: starboard, along: 3.5, direction: inward, limit: 1000}
  - {name: C, edge: port, along: 0.5, direction: inward, limit: 1000}
  - {name: D, edge: port, along: 3.5, direction: inward, limit: 1000}
  - {name: E, edge: bow, along: 1, direction: inward, limit: 1000}
  - {name: F, edge: stern, along: 1, direction: inward, limit: 1000}
"""


@pytest.fixture
def windy(tmp_path):
    """Return a function that writes six robots on a pontoon in the wind, and more if wanted."""

    def windy(more=""):
        path = tmp_path / "windy.yaml"
        wind = "wind: {vessel: tender, frontal_area: 6, lateral_area: 20}"
        path.write_text(f"{PONTOON}environment: {{{wind}{more}}}\n")
        return path

    return windy


def test_tells_the_least_wind_and_the_worst_loss(run):
    """Headline, facts and a table of bearings."""
    status, said, complaints = run("capability", "supply-vessel")
    assert (status, complaints) == (0, "")
    lines = said.splitlines()
    assert lines[0] == "Supply vessel: holds 73.0 kn (37.6 m/s, Beaufort 12) from any bearing"
    assert "Intact             least from 70 deg: 73.0 kn (37.6 m/s, Beaufort 12)" in lines
    assert "                   there the robots are weakest at moving to starboard" in lines
    assert "Without one robot  least from 55 deg: 58.9 kn (30.3 m/s, Beaufort 10)" in lines
    assert "                   the worst loss there: port propeller" in lines
    assert "Current            1.50 kn (0.77 m/s), from where the wind comes" in lines
    assert "Allowance          all loads times 1.25" in lines
    rows = [row.split() for row in lines if row.strip()[:1].isdigit()]
    assert [row[0] for row in rows] == [
        "0", "30", "55", "60", "70", "90", "120", "150", "180", "210", "240", "270", "300", "330"
    ]  # fmt: skip
    assert "Computed every 5 degrees; --json has them all." in lines


def test_a_current_of_ones_own(run, windy):
    """In knots, instead of the scenario's; more of it, less wind."""
    file = windy(", current: {frontal_area: 2, lateral_area: 8, speed: 0.5}")
    winds = []
    for knots in (0, 1, 2):
        status, said, _ = run("capability", file, "--current", f"{knots}kn", "--json", "-")
        found = json.loads(said)
        assert status == 0
        assert found["environment"]["current"]["speed"] == pytest.approx(knots * KNOT)
        winds.append(found["intact"][0])
    assert winds[0] > winds[1] > winds[2] > 0.0


def test_json_holds_every_bearing(run, windy, tmp_path):
    """SI units and radians; a current that is not held is told."""
    target = tmp_path / "winds.json"
    file = windy(", current: {frontal_area: 2, lateral_area: 8, speed: 0.5, from: 3.0}")
    status, said, _ = run("capability", file, "--step", 45, "--json", target)
    found = json.loads(target.read_text())
    assert status == 0
    assert said.endswith(f"wrote {target}\n")
    assert found["bearings"] == [math.radians(45 * k) for k in range(8)]
    assert (found["losing"], found["environment"]["current"]["bearing"]) == (1, 3.0)
    assert all(lost in (["C"], ["D"], ["E"]) for lost in found["worst_losses"])  # each as bad
    assert all(found["holds_calm"])
    assert not any(found["holds_calm_after_loss"])
    assert "Without one robot  no wind from any bearing, not even the current alone" in said
    assert re.search("losing [CDE] is enough", said)


def test_the_worst_case_is_the_scenarios_or_asked_for(run, windy):
    """With tolerances only; robots that may be weaker hold less."""
    file = windy()
    said = run("capability", file, "--json", "-")[1]
    status, _, complaints = run("capability", file, "--worst-case")
    assert (status, "no robot has a tolerance" in complaints) == (2, True)
    weak = "tolerance: {least_limit: 500}, limit: 1000}"
    file.write_text(file.read_text().replace("limit: 1000}", weak))
    weaker = json.loads(run("capability", file, "--worst-case", "--json", "-")[1])
    assert weaker["worst_case"]
    strong = json.loads(said)["intact"][0]
    assert weaker["intact"][0] == pytest.approx(strong / math.sqrt(2.0))
    assert "Poses" in run("capability", file, "--worst-case")[1]


def test_winds_are_not_told_beyond_a_hundred_knots(run, windy):
    """As capability plots end there."""
    file = windy()
    file.write_text(file.read_text().replace("1000}", "1000000}"))
    said = run("capability", file, "--step", 90)[1]
    assert "holds more than 100 kn from any bearing" in said
    assert said.count(">100") == 4


def test_the_plot_is_written(run, windy, tmp_path):
    """Beside the report, or beside JSON."""
    target = tmp_path / "plot.svg"
    status, said, _ = run("capability", windy(), "--step", 30, "--plot", target)
    assert (status, said.splitlines()[-1]) == (0, f"wrote {target}")
    assert target.stat().st_size > 10_000
    target.unlink()
    status, said, aside = run("capability", "model-ship", "--plot", target, "--json", "-")
    assert (status, aside) == (0, f"wrote {target}\n")
    assert target.exists()
    assert json.loads(said)["name"] == "Model ship"


def test_faults_come_before_any_work(run, pontoon, windy):
    """All at once; a missing environment is told with its place and an example."""
    status, said, complaints = run(
        "capability", pontoon, "--losing", "1.5", "--step", 0.5, "--current", -1, "--plot", "a.jpg"
    )
    assert (status, said) == (2, "")
    assert [line.split(" is ")[0] for line in complaints.splitlines()[:3]] == [
        "--losing", "--step", "--current"
    ]  # fmt: skip
    assert "a.jpg: the name should end in" in complaints
    status, said, complaints = run("capability", pontoon)
    assert (status, said) == (2, "")
    assert complaints.startswith(f"{pontoon}:1:1: environment: is missing; say what the object ")
    assert "`environment: {wind: {vessel: offshore supply vessel, " in complaints
    status, _, complaints = run("capability", windy(), "--current", 1)
    assert status == 2
    assert "environment.current: is missing, so --current has nothing to set" in complaints
    answer = pontoon.with_name("answer.json")
    assert run("capability", windy(), "--step", 90, "--json", answer)[0] == 0
    status, _, complaints = run("capability", answer, "--current", 1)
    assert status == 2
    assert "the largest wind held, with no current: --current needs one; ask it" in complaints


FULL = ", current: {frontal_area: 2, lateral_area: 8, speed: 0.5}, dynamic_factor: 1.25"


def test_numbers_are_told_with_their_weather_and_what_they_are_not(run, windy, tmp_path):
    """As found in Python; asked again, the answer is the same."""
    target, picture = tmp_path / "numbers.json", tmp_path / "numbers.svg"
    file = windy(FULL)
    status, said, _ = run(
        "capability", file, "--numbers", "--step", 45, "--json", target, "--plot", picture
    )
    found = json.loads(target.read_text())
    scenario = load_scenario(file)
    expected = capability_numbers(scenario.swarm, scenario.environment, found["bearings"])
    assert status == 0
    assert found["intact"] == expected.intact.tolist()
    least = min(found["intact"])
    after = min(found["after_loss"])
    assert said.startswith(f"Pontoon: holds step {least} of 11 from any bearing, {after} after the")
    assert "These are no capability numbers by DNV-ST-0111" in said
    assert "all loads times 1.25\n" in said
    assert picture.stat().st_size > 10_000
    again = json.loads(run("capability", target, "--json", "-")[1])
    assert [again[key] for key in ("intact", "after_loss")] == [
        found[key] for key in ("intact", "after_loss")
    ]
    status, _, complaints = run("capability", windy(), "--numbers")
    assert (status, "has no current, and every step has one" in complaints) == (2, True)


def test_use_is_told_for_the_wind_asked_for(run, windy, tmp_path):
    """The busiest robot and each robot's share; not held is said with where."""
    target, picture = tmp_path / "use.json", tmp_path / "use.png"
    file = windy(FULL)
    ask = ("capability", file, "--step", 45, "--plot", picture)
    status, said, _ = run(*ask, "--use", "10kn", "--json", target)
    found = json.loads(target.read_text())
    scenario = load_scenario(file)
    use = thrust_use(scenario.swarm, scenario.environment, 10 * KNOT, found["bearings"])
    at = use.busiest
    assert status == 0
    assert all(found["held"])
    assert found["speed"] == pytest.approx(10 * KNOT)
    busiest = f"busiest {use.busiest_at(at)}, {100 * use.largest[at]:.0f} % from {45 * at} deg"
    assert said.startswith(f"Pontoon: held in 10.0 kn (5.14 m/s) from every bearing; {busiest}")
    assert json.loads(run("capability", target, "--json", "-")[1])["shares"] == found["shares"]
    said = run(*ask, "--use", "90kn")[1]
    assert said.startswith("Pontoon: not held in 90.0 kn (46.3 m/s) from ")
    status, _, complaints = run(*ask, "--use", "10kN", "--numbers")
    assert status == 2
    assert "--numbers and --use each ask something else; keep one" in complaints
    assert "--use is 10kN: 'kN' is a unit of force, not of speed; did you mean 'kn'?" in complaints


def test_before_and_after_a_newcomer(run, windy, tmp_path):
    """Two capabilities in one table and one picture: without it, and with it where place says."""
    target, picture = tmp_path / "joined.json", tmp_path / "joined.svg"
    file = windy(FULL)
    assert "has no newcomer" in run("capability", file, "--with-newcomer")[2]
    file.write_text(f"{file.read_text()}newcomer: {{name: G, limit: 1500, attachment: push}}\n")
    ask = ("capability", file, "--step", 45)
    told = run(*ask, "--with-newcomer", "--json", target, "--plot", picture)
    found = json.loads(target.read_text())
    alone = json.loads(run(*ask, "--json", "-")[1])
    placed = json.loads(run("place", file, "--json", "-")[1])["placements"][0]["robot"]
    assert told[0] == 0
    assert found["before"]["intact"] == alone["intact"]
    assert found["robot"] == placed
    assert max(found["after"]["intact"]) > max(alone["intact"])
    assert "from any bearing with G" in told[1]
    assert "before [kn]  after [kn]  loss, before [kn]  loss, after [kn]" in told[1]
    assert "without G" in picture.read_text() or picture.stat().st_size > 10_000


def test_place_for_capability(run, tmp_path):
    """The least wind held before and after, an answer that verifies, and no other options."""
    target = tmp_path / "placed.json"
    ask = ("place", "harbour-tugs", "--for", "capability")
    status, said, _ = run(*ask, "--json", target)
    assert status == 0
    scenario = load_example("harbour-tugs")
    found = place_for_capability(scenario.problem(), scenario.environment)
    assert said.startswith(
        f"Harbour tugs: the best place for Electra: {found.after / KNOT:.1f} kn ({found.after:.1f} "
    )
    assert re.search(r"Least wind held  .* -> .* from [0-9]+ deg \(\+[0-9.]+ %\)", said)
    assert run("verify", target)[0] == 0
    status, _, complaints = run(*ask, "--wind", "3", "--robots", "2")
    assert status == 2
    assert complaints.splitlines() == [
        "--wind is of one wind, and --for capability of all: leave it out",
        "--for capability places one robot: leave out --robots, --together and --where-not",
    ]
