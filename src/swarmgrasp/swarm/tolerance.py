"""How far a robot may be from where it is thought to be."""

import math
from dataclasses import dataclass

from swarmgrasp.errors import RobotInvalid
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import flag_faults, limit_faults, numbers, shown


@dataclass(frozen=True)
class Tolerance(Plain):
    """How far a robot's pose and strength may be from what they are said to be.

    Attributes
    ----------
    contact : float or tuple of float [m]
        The contact lies on the boundary within this distance either way, measured along it and
        across corners; or between two offsets, counter-clockwise, the first at most 0 and the
        second at least 0. Kept as two offsets.
    direction : float or tuple of float [rad]
        The same for the direction of the force, counter-clockwise.
    least_limit : float [N], optional
        The limit is at least this much; the robot's own limit when left out.
    may_be_absent : bool
        Whether the robot may not be there at all.

    Raises
    ------
    RobotInvalid
        If a value is outside its range; all faults at once.

    Examples
    --------
    >>> Tolerance(contact=2.0, direction=(-0.1, 0.0)).contact
    (-2.0, 2.0)
    """

    contact: float | tuple[float, float] = 0.0
    direction: float | tuple[float, float] = 0.0
    least_limit: float | None = None
    may_be_absent: bool = False

    def __post_init__(self) -> None:
        """Check the values."""
        faults = []
        for name, unit, most in (("contact", "m", math.inf), ("direction", "rad", math.pi)):
            given = getattr(self, name)
            ends = numbers(given) or tuple(x for v in numbers((given,)) for x in (-v, v))
            if len(ends) == 2 and -most <= ends[0] <= 0.0 <= ends[1] <= most:
                object.__setattr__(self, name, (ends[0] + 0.0, ends[1] + 0.0))
                continue
            reach = "" if most == math.inf else " and at most pi"
            faults.append(
                f"the {name} tolerance is {shown(given)}; it should be a number >= 0{reach}, or "
                f"two offsets, the first <= 0 and the second >= 0 [{unit}]"
            )
        if self.least_limit is not None:
            faults += [f"least limit: {fault}" for fault in limit_faults(self.least_limit)]
        faults += flag_faults(self.may_be_absent, "may_be_absent")
        if faults:
            raise RobotInvalid(faults)
        vars(self).update(
            least_limit=None if self.least_limit is None else float(self.least_limit),
            may_be_absent=bool(self.may_be_absent),
        )

    @property
    def offsets(self) -> tuple[float, float]:
        """The contact's two offsets along the boundary [m]."""
        return self.contact  # type: ignore[return-value]

    @property
    def turns(self) -> tuple[float, float]:
        """The direction's two offsets [rad]."""
        return self.direction  # type: ignore[return-value]

    @property
    def is_adrift(self) -> bool:
        """Whether the contact is uncertain."""
        return self.offsets != (0.0, 0.0)

    @property
    def is_spread(self) -> bool:
        """Whether contact or direction is uncertain."""
        return self.is_adrift or self.turns != (0.0, 0.0)
