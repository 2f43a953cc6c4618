"""The ranges that areas, speeds and coefficients lie in, and what is said of those that do not."""

from dataclasses import dataclass

from swarmgrasp.ranges import number, shown


@dataclass(frozen=True)
class Range:
    """What a number may be.

    Attributes
    ----------
    low, high : float
    unit : str
    """

    low: float
    high: float
    unit: str

    def faults(self, name: str, value: object) -> list[str]:
        """Return what is wrong with a number.

        Examples
        --------
        >>> Range(0.0, 1e3, "m/s").faults("speed", -1)
        ['the speed is -1; it should be 0 <= speed <= 1000 [m/s]']
        """
        if self.low <= number(value) <= self.high:
            return []
        return [
            f"the {name} is {shown(value)}; it should be {self.low:g} <= {name} <= {self.high:g} "
            f"[{self.unit}]"
        ]


AREA = Range(1e-9, 1e9, "m^2")
OFFSET = Range(-1e9, 1e9, "m")
SPEED = Range(0.0, 1e3, "m/s")
BEARING = Range(-1e6, 1e6, "rad")
DENSITY = Range(1e-3, 1e5, "kg/m^3")
COEFFICIENT = Range(1e-6, 10.0, "1")
"""A flat plate across the stream has about 2."""
CROSS_FORCE = Range(0.0, 1.0, "1")
DYNAMIC_FACTOR = Range(1.0, 10.0, "1")
HEIGHT = Range(0.0, 100.0, "m")
PERIOD = Range(1e-3, 1e3, "s")
BOW_ANGLE = Range(1e-3, 1.6, "rad")
FULLNESS = Range(0.0, 2.0, "1")
