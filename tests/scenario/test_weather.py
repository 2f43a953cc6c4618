"""The environment of a scenario file: units, defaults and faults."""

import math

import pytest

from swarmgrasp.environment import BLENDERMANN, KNOT, CurrentCoefficients, Waves, WindCoefficients
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import parse_scenario
from swarmgrasp.units import LENGTHS

HEAD = "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\nrobots: []\n"
WIND = "vessel: ferry, frontal_area: 1, lateral_area: 2"


def environment(text: str, units: str = ""):
    return parse_scenario(f"{units}{HEAD}environment: {text}\n", "a.yaml").environment


def test_units_of_wind_and_current() -> None:
    """Feet, degrees and knots in the file; metres, radians and metres per second behind it."""
    found = environment(
        "{wind: {vessel: ferry, frontal_area: 100, lateral_area: 300, lateral_centroid: -5, "
        "speed: 20, from: 90}, current: {frontal_area: 40, lateral_area: 90, speed: 2, from: -45}, "
        "dynamic_factor: 1.25}",
        "units: {length: ft, angle: deg, speed: knot}\n",
    )
    wind, current = found.wind, found.current
    assert (wind.frontal_area, wind.lateral_area) == pytest.approx((9.290304, 27.870912))
    assert wind.lateral_centroid == pytest.approx(-1.524)
    assert (wind.speed, wind.bearing) == pytest.approx((20 * KNOT, math.pi / 2))
    assert (current.speed, current.bearing) == pytest.approx((2 * KNOT, -math.pi / 4))
    assert current.lateral_area == pytest.approx(8.3612736)
    assert (wind.coefficients, found.dynamic_factor) == (BLENDERMANN["ferry"], 1.25)


@pytest.mark.parametrize("unit", ["mm", "cm", "m", "in"])
def test_a_large_ship_in_a_high_sea_may_be_written_in_any_unit(unit: str) -> None:
    """Her side is more than a thousand million square millimetres, 6 m of sea more than 1000 mm."""
    one = LENGTHS[unit]
    found = environment(
        f"{{wind: {{vessel: ferry, frontal_area: {300 / one**2}, lateral_area: {1200 / one**2}}}, "
        f"waves: {{height: {6 / one}, period: 9, from: 0}}}}",
        f"units: {{length: {unit}}}\n",
    )
    assert found.wind.lateral_area == pytest.approx(1200.0)
    assert found.waves.height == pytest.approx(6.0)


def test_numbers_out_of_range_are_told_at_their_keys_in_the_units_of_the_file() -> None:
    """Each with its key and line, all at once; what a unit that is not read tells is not judged."""
    text = f"""
units: {{length: ft, speed: %s, angle: deg}}
outline: {{vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}}
robots: []
environment:
  wind: {{{WIND}, density: 1e-9, speed: 80, from: 0}}
  current: {{frontal_area: 1e-14, lateral_area: 1, coefficients: {{surge: 1e-9}}}}
  waves: {{with_wind: true, bow_angle: 1e-9}}
"""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(text % "kn")
    told = [fault.split(": ", 1)[1] for fault in caught.value.faults]
    assert told == [
        "environment.wind.density: should lie in [0.001, 1e+05] kg/m^3 (got 1e-9)",
        "environment.wind.speed: the sea that goes with a wind is known up to 63.37 kn; give the "
        "waves a height and a period (got 80)",
        "environment.current.frontal_area: should lie in [1.076e-08, 1.076e+10] ft^2 (got 1e-14)",
        "environment.current.coefficients.surge: should lie in [1e-06, 10] (got 1e-9)",
        "environment.waves.bow_angle: should lie in [0.0573, 91.67] deg (got 1e-9)",
    ]
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(text % "furlong/h")
    assert [fault.split(": ")[1] for fault in caught.value.faults] == [
        "units.speed",
        *(fault.split(": ")[0] for fault in told if "wind.speed" not in fault),
    ]


def test_what_is_left_out_has_its_published_value() -> None:
    """SI units, still water, DNV's densities and current coefficients, no allowance."""
    found = environment(f"{{wind: {{{WIND}}}, current: {{frontal_area: 1, lateral_area: 2}}}}")
    assert not found.is_steady
    assert (found.wind.density, found.current.density) == (1.226, 1026.0)
    assert found.current.coefficients == CurrentCoefficients(0.07, 0.6)
    assert (found.current.speed, found.current.bearing, found.dynamic_factor) == (0.0, None, 1.0)
    assert environment(f"{{wind: {{{WIND}}}}}").current is None
    assert parse_scenario(HEAD).environment is None


def test_coefficients_may_be_given() -> None:
    """Instead of a type of vessel, and for the current."""
    found = environment(
        "{wind: {coefficients: {transverse: 1, bow: 0.8, stern: 0.9, cross_force: 0.2}, "
        "frontal_area: 1, lateral_area: 2}, current: {frontal_area: 1, lateral_area: 2, "
        "coefficients: {surge: 0.3}}}"
    )
    assert found.wind.coefficients == WindCoefficients(1.0, 0.8, 0.9, 0.2)
    assert found.current.coefficients == CurrentCoefficients(0.3, 0.6)


def test_waves_are_given_or_go_with_the_wind() -> None:
    """Feet and degrees in the file; what is left out is of the outline."""
    told = "{height: 10, period: 8, from: -30, bow_angle: 30, aft_fullness: 0.9}"
    units = "units: {length: ft, angle: deg}\n"
    sea = environment(f"{{wind: {{{WIND}}}, waves: {told}}}", units).waves
    assert (sea.height, sea.period, sea.bearing) == pytest.approx((3.048, 8.0, -math.pi / 6))
    assert (sea.bow_angle, sea.aft_fullness) == (pytest.approx(math.pi / 6), 0.9)
    assert environment(f"{{wind: {{{WIND}}}, waves: {{with_wind: true}}}}").waves == Waves()
    assert environment(f"{{wind: {{{WIND}}}}}").waves is None


FAULTS = {
    f"{{wind: {{{WIND}}}, waves: {{}}}}": (
        "3:79: environment.waves: should say the sea, by height and period, or by `with_wind: "
        "true`, the sea that goes with the wind"
    ),
    f"{{wind: {{{WIND}}}, waves: {{height: 1}}}}": (
        "3:88: environment.waves.height: waves also need their period (got 1)"
    ),
    f"{{wind: {{{WIND}}}, waves: {{height: 1, with_wind: true}}}}": (
        "3:79: environment.waves: with_wind and height each say the sea; keep one"
    ),
    f"{{wind: {{{WIND}, speed: 40, from: 0}}, waves: {{with_wind: true}}}}": (
        "3:78: environment.wind.speed: the sea that goes with a wind is known up to 32.6 m/s; give "
        "the waves a height and a period (got 40)"
    ),
    "{}": "3:14: environment.wind: is missing; give what the object shows to the wind",
    "{wind: {frontal_area: 1, lateral_area: 2}}": (
        "3:21: environment.wind: should say its drag, by vessel, a type such as 'offshore supply "
        "vessel', or by coefficients"
    ),
    f"{{wind: {{{WIND}, coefficients: {{transverse: 1, bow: 1, stern: 1}}}}}}": (
        "3:21: environment.wind: vessel and coefficients each say the drag; keep one"
    ),
    "{wind: {vessel: ferry, lateral_area: 2}}": (
        "3:21: environment.wind.frontal_area: is missing; give the area seen from ahead"
    ),
    f"{{wind: {{{WIND}, speed: 3}}}}": (
        "3:78: environment.wind.speed: a wind also needs from, the bearing it comes from (got 3)"
    ),
    f"{{wind: {{{WIND}, from: 3}}}}": (
        "3:77: environment.wind.from: a wind also needs its speed (got 3)"
    ),
    f"{{wind: {{{WIND}, speed: -3, from: 0}}}}": (
        "3:78: environment.wind.speed: should be at least 0 (got -3)"
    ),
    f"{{wind: {{{WIND}}}, dynamic_factor: 0.9}}": (
        "3:88: environment.dynamic_factor: should be at least 1 (got 0.9)"
    ),
    f"{{wind: {{{WIND}}}, current: {{frontal_area: 0, lateral_area: 2}}}}": (
        "3:96: environment.current.frontal_area: should be greater than 0 (got 0)"
    ),
    f"{{wind: {{{WIND}}}, current: {{frontal_area: 1e-20, lateral_area: 2}}}}": (
        "3:96: environment.current.frontal_area: should lie in [1e-09, 1e+09] m^2 (got 1e-20)"
    ),
}


def test_a_wrong_vessel_is_shown_all_types_and_no_other_ship() -> None:
    """A bulk carrier is no car carrier, however alike their letters."""
    with pytest.raises(ScenarioInvalid) as caught:
        environment("{wind: {vessel: bulk carrier, frontal_area: 1, lateral_area: 2}}")
    (fault,) = caught.value.faults
    assert "did you mean" not in fault
    assert all(repr(vessel) in fault for vessel in BLENDERMANN)


def test_a_vessel_with_a_comma_goes_in_quotes() -> None:
    """In a flow mapping the comma ends the value, and the rest becomes a key."""
    with pytest.raises(ScenarioInvalid) as caught:
        environment("{wind: {vessel: tanker, in ballast, frontal_area: 1, lateral_area: 2}}")
    assert list(caught.value.faults) == [
        "a.yaml:3:30: environment.wind.vessel: there is no such type of vessel; put a type with a "
        "comma in quotes: 'tanker, loaded' or 'tanker, in ballast' (got 'tanker')",
        "a.yaml:3:38: environment.wind.in ballast: has no value; if it goes on a text with a "
        "comma, put the text in quotes",
    ]


@pytest.mark.parametrize("text", FAULTS)
def test_a_fault_is_told_with_its_place(text: str) -> None:
    """One fault, one sentence, with line, column and key path."""
    with pytest.raises(ScenarioInvalid) as caught:
        environment(text)
    assert list(caught.value.faults) == [f"a.yaml:{FAULTS[text]}"]


def test_faults_of_wind_and_current_are_told_with_all_others() -> None:
    """None hides another."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(
            "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
            "robots: [{at: 99, direction: 0, limit: 1}]\n"
            "environment:\n"
            "  wind: {vessel: boat, frontal_area: x, lateral_area: 2}\n"
            "  current: {speed: fast}\n"
        )
    keys = [fault.split(": ")[1] for fault in caught.value.faults]
    assert keys == [
        "robots.0.at",
        "environment.wind.vessel",
        "environment.wind.frontal_area",
        "environment.current.frontal_area",
        "environment.current.lateral_area",
        "environment.current.speed",
    ]
