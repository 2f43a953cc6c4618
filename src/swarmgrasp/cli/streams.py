"""What an option says of a stream or a sea: its speed, where it comes from, its height."""

from swarmgrasp.cli.amounts import Amount
from swarmgrasp.cli.inputs import UsageFault, blaming
from swarmgrasp.units import bearing

MOST_TURNED = 1e6
"""Largest bearing [deg]."""


def speed_given(option: str, text: str) -> Amount:
    """Return the speed of wind or water that an option gives."""
    from swarmgrasp.environment.limits import SPEED

    return Amount(option, text, "speed", SPEED.low, SPEED.high)


def bearing_given(option: str, text: str, heading: float | None) -> float:
    """Return a bearing [rad] clockwise from the bow; a number alone is in degrees."""
    from math import radians

    with blaming(f"{option} is {text}"):
        found = bearing(text, "deg", heading)
    if abs(found) > MOST_TURNED:
        raise UsageFault(
            f"{option} is {text}; it should be from {-MOST_TURNED:g} to {MOST_TURNED:g} deg"
        )
    return radians(found)


def sea_given(text: str) -> tuple[Amount, Amount]:
    """Return the significant height and the peak period of a sea."""
    from swarmgrasp.environment.limits import HEIGHT, PERIOD

    parts = text.split(",")
    if len(parts) != 2:
        raise UsageFault(
            f"--waves is {text}: it should be wind, for the sea that goes with the wind, or a "
            "significant height and a peak period, such as 2.1m,7.5s"
        )
    called = f"--waves is {text}: the"
    return (
        Amount(f"{called} height", parts[0], "length", HEIGHT.low, HEIGHT.high),
        Amount(f"{called} period", parts[1], "time", PERIOD.low, PERIOD.high),
    )
