"""Quantities are read with the units that people write."""

import math
import subprocess
import sys

import pint
import pytest

from swarmgrasp.environment import STEPS
from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.units import PLAIN, beaufort_number, beaufort_speed, quantity, size, spellings

AS_PINT = {
    "°": "degree", "in": "inch", "kip": "kip", "kn": "knot", "t": "metric_ton",
    "tf": "force_metric_ton",
}  # fmt: skip


def test_the_sizes_kept_here_are_those_of_the_library() -> None:
    """Each is the float nearest to the exact one, or one of a few beside it."""
    registry = pint.UnitRegistry()
    for of, sizes in PLAIN.items():
        si = {"force": "newton", "mass": "kilogram"}.get(of, "")
        for name, held in sizes.items():
            told = registry.Quantity(1.0, AS_PINT.get(name, name))
            told = told.to(si) if si else told.to_base_units()
            assert held == pytest.approx(told.magnitude, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "of", "wanted"),
    [
        ("60 t", "force", 588399.0),
        ("60tf", "force", 588399.0),
        ("60 tonne-force", "force", 588399.0),
        ("600kN", "force", 6e5),
        ("0.6 MN", "force", 6e5),
        ("1 kip", "force", 4448.2216152605),
        ("1000 lbf", "force", 4448.2216152605),
        ("5.25 kgf", "force", 5.25 * 9.80665),
        ("5 daN", "force", 50.0),
        ("1 t", "mass", 1000.0),
        ("90 deg", "angle", math.pi / 2.0),
        ("\u221290°", "angle", -math.pi / 2.0),
        ("1 Radian", "angle", 1.0),
        ("25 kn", "speed", 25.0 * 1852.0 / 3600.0),
        ("25KNOTS", "speed", 25.0 * 1852.0 / 3600.0),
        ("36 km/h", "speed", 10.0),
        ("10 ft / s", "speed", 3.048),
        ("4 Bft", "speed", 7.9),
        ("1.5e3 mm", "length", 1.5),
        ("12 in", "length", 0.3048),
        ("2 yards", "length", 1.8288),
        ("2 nautical miles", "length", 3704.0),
        ("20 ft2", "area", 20 * 0.3048**2),
        ("20 square feet", "area", 20 * 0.3048**2),
        ("3 t m", "torque", 3 * 9806.65),
        ("3 kNm", "torque", 3000.0),
        ("3 ft-lbf", "torque", 3 * 0.3048 * 4.4482216152605),
        ("1.025 t/m³", "density", 1025.0),
        ("12 deg/s", "turn rate", math.radians(12.0)),
        ("10 min", "time", 600.0),
    ],
)
def test_what_people_write_is_read(text: str, of: str, wanted: float) -> None:
    """A t is a force where a force is wanted, and a mass where a mass is."""
    assert quantity(text, of) == pytest.approx(wanted, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "of", "said"),
    [
        ("25 kN", "speed", "'kN' is a unit of force, not of speed; did you mean 'kn'?"),
        ("60 kn", "force", "'kn' is a unit of speed, not of force; did you mean 'kN'?"),
        ("60 KN", "force", "there is no unit of force 'KN'; did you mean 'kN'?"),
        ("60 hp", "force", "there is no unit of force 'hp'; known: N, kN, MN, kgf, tf, lbf, kip"),
        ("60 tons", "force", "a ton may be short, long or metric"),
        ("5 Mm", "length", "there is no unit of length 'Mm'; did you mean 'mm'?"),
        ("1,5 t", "force", "write decimals after a point"),
        ("1 000 kN", "force", "write them together"),
        ("fast", "speed", "'fast' is no speed; write a number, or one with its unit, such as"),
        ("nan", "force", "'nan' is no force"),
        ("1e999 N", "force", "no finite number"),
        ("5 m", "area", "'m' is no unit of area"),
        ("4.5 Bft", "speed", "a whole number from 0 to 11"),
        ("12 Bft", "speed", "a whole number from 0 to 11"),
        ("5 m^2 (about)", "area", "is no unit of area"),
    ],
)
def test_a_slip_is_told_with_its_remedy(text: str, of: str, said: str) -> None:
    """Of another quantity, vague, or misspelled."""
    with pytest.raises(QuantityInvalid) as caught:
        quantity(text, of)
    assert said in str(caught.value)


def test_common_units_load_no_library() -> None:
    """A command with "25kn" starts as fast as one without."""
    told = "; ".join(f"quantity('2 {u}', {of!r})" for of in PLAIN for u in spellings(of))
    code = (
        f"import sys; from swarmgrasp.units import quantity; {told}; print('pint' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "False\n"


def test_rare_units_are_exact() -> None:
    """They come from the library as fractions."""
    assert size("yard", "length") == 0.9144


def test_the_scale_of_winds_goes_both_ways() -> None:
    """The strongest wind of a number has that number, and a little more the next."""
    for force in range(12):
        assert beaufort_number(beaufort_speed(force)) == force
        assert beaufort_number(beaufort_speed(force) - 0.1) == max(0, force - 1)


def test_the_winds_of_the_steps_are_those_of_the_scale() -> None:
    """The strongest of each number; but for step 2, which the standard has at 3.4 m/s."""
    winds = {number: step.wind for number, step in enumerate(STEPS)}
    assert winds.pop(0) == 0.0
    assert winds.pop(2) == 3.4
    assert winds == {number: beaufort_speed(number) for number in winds}
