"""What happens during a run, in sentences: in the units, frame and bearings of its readers."""

import math
from collections.abc import Mapping
from dataclasses import replace

from swarmgrasp.telling import Telling
from swarmgrasp.words import digits, plain_seconds

COARSE = 2
"""Decimals less than those of answers that tell where a robot attaches."""


def sentence(kind: str, robot: str, numbers: Mapping[str, float], tell: Telling) -> str:
    """Return what is told of a happening that has numbers.

    Parameters
    ----------
    kind : {"sent", "aim", "weather"}
    robot : str
        Who is sent.
    numbers : mapping of str to float
        As `Happening.numbers` has them.
    tell : Telling

    Examples
    --------
    >>> from swarmgrasp.terms import Frame, Terms
    >>> marine = Telling.of(Terms("ft", speed="kn", frame=Frame(mirrored=True)), 80.0, [])
    >>> sentence("aim", "", {"x": 3.048, "y": 6.096, "heading": math.radians(-10)}, marine)
    'the object is to move to (10, -20) ft, heading 10 deg'
    >>> sentence("weather", "", {"wind_speed": 15.433, "wind_bearing": 1.3089969}, marine)
    'the weather changes: wind 30 kn from 75 deg'
    """
    if kind == "sent":
        way = f"{length_text(numbers['away'], tell)} to go"
        comes = plain_seconds(numbers["joins"])
        return f"{robot} is sent to {_place(numbers, tell)}, {way}; it joins at {comes} s"
    if kind == "aim":
        how = "a path is to be followed to" if "speed" in numbers else "the object is to move to"
        pace = f", at {tell.speed(numbers['speed'])}" if "speed" in numbers else ""
        return f"{how} {_aim(numbers, tell)}, heading {_heading(numbers['heading'], tell)}{pace}"
    streams = [_stream(name, numbers, tell) for name in ("wind", "current")]
    return f"the weather changes: {', '.join(filter(None, streams))}"


def length_text(length: float, tell: Telling) -> str:
    """Return a length [m] to three digits, with its unit.

    Examples
    --------
    >>> from swarmgrasp.terms import Terms
    >>> length_text(406.43, Telling.of(Terms("ft"), 80.0, []))
    '1333 ft'
    """
    value = length / tell.length.metres
    return f"{digits(value, value, 3)} {tell.length.name}"


def from_text(x: float, y: float, tell: Telling) -> str:
    """Say where a stream (x, y) of the earth's frame comes from.

    Examples
    --------
    >>> from swarmgrasp.terms import SI
    >>> from_text(0.0, 2.0, Telling.of(SI, 80.0, []))
    'from 90 deg'
    """
    return tell.from_words(math.atan2(y, -x))


def _place(numbers: Mapping[str, float], tell: Telling) -> str:
    """Return a place on the outline, coarsely."""
    coarse = replace(tell.length, decimals=max(0, tell.length.decimals - COARSE))
    return replace(tell, length=coarse).point((numbers["x"], numbers["y"]))


def _aim(numbers: Mapping[str, float], tell: Telling) -> str:
    """Return a place where the object is to be."""
    x, y = tell.terms.frame.to_file((numbers["x"], numbers["y"])) / tell.length.metres
    return f"({x:.6g}, {y:.6g}) {tell.length.name}"


def _heading(heading: float, tell: Telling) -> str:
    """Return a heading [rad], counter-clockwise from that at the start, as the file counts it."""
    frame = tell.terms.frame
    if frame.heading is not None:
        return f"{round(math.degrees(frame.bearing(heading)), 6) % 360.0:g} deg true"
    is_clockwise = frame.mirrored or tell.terms.bearings
    return f"{round(math.degrees(-heading if is_clockwise else heading), 6) + 0.0:g} deg"


def _stream(name: str, numbers: Mapping[str, float], tell: Telling) -> str:
    """Return what changes of the wind or the current."""
    speed, bearing = numbers.get(f"{name}_speed"), numbers.get(f"{name}_bearing")
    said = [name]
    if speed is not None:
        said.append(tell.speed(speed))
    if bearing is not None:
        said.append(tell.from_words(bearing))
    return " ".join(said) if len(said) > 1 else ""
