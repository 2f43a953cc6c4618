"""What people write for a key or a value, and what this program calls it."""

from collections.abc import Sequence

from swarmgrasp.ranges import unknown_key

_MEANT = {
    "angle": ("direction",),
    "arm": ("contact",),
    "azimuth": ("steers",),
    "bollard_pull": ("limit",),
    "bearing": ("from",),
    "force": ("limit",),
    "geometry": ("outline",),
    "heading": ("direction",),
    "hull": ("outline",),
    "location": ("contact",),
    "max_force": ("limit",),
    "max_thrust": ("limit",),
    "points": ("vertices",),
    "polygon": ("outline", "vertices"),
    "position": ("contact",),
    "power": ("limit",),
    "pull": ("limit",),
    "thrust": ("limit",),
    "thrusters": ("robots",),
    "tugs": ("robots",),
    "unit": ("units",),
    "vessel_type": ("vessel",),
    "wind_speed": ("speed",),
}
"""Words for keys, and the keys that they may mean, where there is one of them."""
_YAML = {
    "mapping values are not allowed here": "a colon makes a key here; put a text with a colon in "
    "quotes",
    "found character '\\t' that cannot start any token": "a tab stands where spaces should; indent "
    "with spaces",
}
"""What a YAML parser says, and what it means to people."""


def key_hint(key: str, known: Sequence[str], top: Sequence[str]) -> str:
    """Return the fault of a key that its mapping does not have.

    Parameters
    ----------
    key : str
    known : sequence of str
        The keys of its mapping.
    top : sequence of str
        Those of the whole file.

    Examples
    --------
    >>> key_hint("max_thrust", ["name", "limit"], ["robots"])
    "unknown key; did you mean 'limit'?"
    >>> key_hint("frame", ["wind", "current"], ["frame", "robots"])
    'unknown key here; frame is a key of the whole file: write it at the left margin'
    """
    for meant in _MEANT.get(key.lower(), ()):
        if meant in known:
            return f"unknown key; did you mean {meant!r}?"
    if key in top and key not in known:
        return f"unknown key here; {key} is a key of the whole file: write it at the left margin"
    return unknown_key(key, known)


def value_hint(key: str, value: object) -> str:
    """Return what to write for a value that its key does not take, "" if nothing comes to mind.

    Examples
    --------
    >>> value_hint("direction", "any"), value_hint("direction", "up")
    ('; what turns any way has steers: any', '')
    """
    if key == "direction" and value == "any":
        return "; what turns any way has steers: any"
    if key == "direction" and isinstance(value, list):
        return "; what turns within a range has steers, or sectors"
    if key == "two_way" and isinstance(value, float):
        return "; limits that differ are limit: {ahead: .., astern: ..}"
    return ""


def yaml_hint(said: str) -> str:
    """Return what a YAML parser says in other words, where it speaks of itself.

    Examples
    --------
    >>> yaml_hint("mapping values are not allowed here")
    'a colon makes a key here; put a text with a colon in quotes'
    """
    return next((told for jargon, told in _YAML.items() if jargon in said), said)
