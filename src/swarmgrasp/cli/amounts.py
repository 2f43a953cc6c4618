"""Amounts on the command line: a number with its unit, or one in the units of the answer."""

import math
from dataclasses import dataclass
from typing import Final

from swarmgrasp.cli.inputs import UsageFault, noting
from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.terms import SI, Terms
from swarmgrasp.units import is_quantity, quantity, split
from swarmgrasp.units.quantity import KINDS

OF_THE_FILE: Final = ("length", "force", "speed", "torque")
"""What a file names units of, angles aside, which are told in degrees."""


@dataclass(frozen=True)
class Amount:
    """What an option gives: a length, a force, a speed or the like.

    Attributes
    ----------
    option : str
        What messages call it.
    text : str
        As it was given.
    of : str
        What it measures, as `swarmgrasp.units.quantity` names it.
    low, high : float [SI]
        The range it should lie in.

    Examples
    --------
    >>> ring = Amount("--limit", "60", "force")
    >>> ring.value(Terms(force="tf")), ring.value(), Amount("--limit", "60kN", "force").value()
    (588399.0, 60.0, 60000.0)
    >>> Amount("--turn", "90", "angle").value(), Amount("--turn", "0.25 m", "angle").faults()
    (1.5707963267948966, ["--turn is 0.25 m: 'm' is a unit of length, not of angle; known: deg, \
rad"])
    >>> Amount("--wind", "5000kn", "speed", 0.0, 1e3).faults()
    ['--wind is 5000kn; it should be from 0 to 1944 kn']
    """

    option: str
    text: str
    of: str
    low: float = -math.inf
    high: float = math.inf

    def faults(self) -> list[str]:
        """Return what is wrong with it, whatever the units of a number that has none."""
        faults: list[str] = []
        with noting(faults):
            value = self._read(SI)
            if is_quantity(self.text) or self.of not in OF_THE_FILE:
                self._check(value, SI)
            elif self.low >= 0.0 and (value < 0.0 or value == 0.0 < self.low):
                least = "at least" if self.low == 0.0 else "more than"
                raise UsageFault(f"{self.option} is {self.text}; it should be {least} 0")
        return faults

    def value(self, terms: Terms = SI) -> float:
        """Return it in SI units; without a unit it is in those of the answer.

        Raises
        ------
        UsageFault
            If it is no such amount, or outside its range.
        """
        value = self._read(terms)
        self._check(value, terms)
        return value

    def _read(self, terms: Terms) -> float:
        """Return it in SI units, whatever its range."""
        try:
            return quantity(self.text, self.of, terms.unit_of(self.of))
        except QuantityInvalid as error:
            raise UsageFault(
                f"{self.option} is {self.text}: {fault}" for fault in error.faults
            ) from None

    def _check(self, value: float, terms: Terms) -> None:
        """Raise if it is outside its range."""
        if self.low <= value <= self.high:
            return
        unit = split(self.text, self.of)[1] or terms.unit_of(self.of) or KINDS[self.of].si
        size = quantity(1.0, self.of, unit)
        low, high = (f"{end / size:.4g}" for end in (self.low, self.high))
        wanted = f"from {low} to {high} {unit}" if self.high < math.inf else f"{low} {unit} or more"
        raise UsageFault(f"{self.option} is {self.text}; it should be {wanted}")
