"""What station keeping is told: how often it looks, how fast it acts, how well it sees."""

import math
from dataclasses import dataclass
from typing import NamedTuple

from swarmgrasp.environment.limits import Range
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import is_number

PERIOD = Range(1e-5, 1e3, "s")
FREQUENCY = Range(1e-6, 1e3, "rad/s")
LONGEST_LOOK = 0.5
"""Of 1 / observer, the longest period: from 4 - 2 sqrt(3) = 0.536 on, what is believed diverges."""
NOISE = Range(0.0, 1e3, "m")
TURN_NOISE = Range(0.0, math.pi, "rad")


class Tuning(NamedTuple):
    """How station keeping is set, with everything said, as in `Control`."""

    period: float
    frequency: float
    observer: float
    position_noise: float
    heading_noise: float


@dataclass(frozen=True)
class Control(Plain):
    """How station keeping is set.

    What is left out follows from the robots' largest lag T and the object's length L.

    Attributes
    ----------
    period : float [s], optional
        Between two looks, and two sets of orders; T / 50 when left out. At most half of 1 over the
        observer's frequency.
    frequency : float [rad/s], optional
        How fast an error is taken back; 0.35 / T when left out: beyond that the loop rings.
    observer : float [rad/s], optional
        How fast what the sensors say is believed; 2.5 times the frequency when left out.
    position_noise : float [m], optional
        Standard deviation of a look, along x and along y; the smaller of 0.3 m and L / 200 when
        left out.
    heading_noise : float [rad]
        Standard deviation of a look at the heading; 0.1 degrees by default.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range; all faults at once.
    """

    period: float | None = None
    frequency: float | None = None
    observer: float | None = None
    position_noise: float | None = None
    heading_noise: float = math.radians(0.1)

    def __post_init__(self) -> None:
        """Check the values."""
        known = {
            "period": PERIOD, "frequency": FREQUENCY, "observer": FREQUENCY,
            "position_noise": NOISE, "heading_noise": TURN_NOISE,
        }  # fmt: skip
        faults = [
            fault
            for name, value in vars(self).items()
            if value is not None or name == "heading_noise"
            for fault in known[name].faults(name.replace("_", " "), value)
        ]
        if faults:
            raise SimulationInvalid(f"control: {fault}" for fault in faults)
        kept = {name: float(value) for name, value in vars(self).items() if is_number(value)}
        vars(self).update(kept)

    def settled(self, lag: float, length: float) -> Tuning:
        """Return the tuning for robots and an object.

        Parameters
        ----------
        lag : float [s]
            The largest of the robots.
        length : float [m]
            Of the object.

        Examples
        --------
        >>> Control(observer=0.2).settled(5.0, 100.0)
        Tuning(period=0.1, frequency=0.06999..., observer=0.2, position_noise=0.3, ...)
        """
        frequency = 0.35 / lag if self.frequency is None else self.frequency
        return Tuning(
            lag / 50.0 if self.period is None else self.period,
            frequency,
            2.5 * frequency if self.observer is None else self.observer,
            min(0.3, length / 200.0) if self.position_noise is None else self.position_noise,
            self.heading_noise,
        )


def loop_faults(control: Control, lag: float, duration: float) -> list[tuple[str, str]]:
    """Return what of a control loop does not go together: what is at fault, and why it is.

    Parameters
    ----------
    control : Control
    lag : float [s]
        The largest of the robots.
    duration : float [s]
        Of the run.

    Examples
    --------
    >>> loop_faults(Control(), 5.0, 0.05)[0][0]
    'duration'
    >>> loop_faults(Control(period=200.0), 5.0, 600.0)[0][0]
    'period'
    """
    missing = [name for name in ("period", "frequency") if getattr(control, name) is None]
    if lag == 0.0 and missing:
        return [
            ("", f"all robots have a lag of 0 s, from which no {' and no '.join(missing)} of the "
                 "control follows; give it")
        ]  # fmt: skip
    tuning, faults = control.settled(lag, 1.0), []
    period, observer = tuning.period, tuning.observer
    if period * observer > LONGEST_LOOK:
        part = "period" if control.period is not None else "observer"
        faults.append(
            (part, f"the control's period is {period:g} s, too long for an observer of "
                   f"{observer:.3g} rad/s; it should be at most {LONGEST_LOOK:g} / observer = "
                   f"{LONGEST_LOOK / observer:.3g} s, or the observer slower")
        )  # fmt: skip
    if duration < period * (1.0 - 1e-9):
        faults.append(
            ("duration", f"the run ends at {duration:g} s, before a period of the control, "
                         f"{period:g} s, is over; let it last longer, or give a shorter period")
        )  # fmt: skip
    return faults
