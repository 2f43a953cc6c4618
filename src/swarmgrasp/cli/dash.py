"""What begins with a hyphen on the command line and is no option.

A lone "-" is standard input, or standard output; "-60deg" is an amount. Cyclopts takes both for
options, unless a parameter accepts everything that begins with a hyphen, mistyped options included.
So a lone "-" is parsed under another name, and an amount is bound to the option before it.
"""

import re
from collections.abc import Sequence
from typing import Annotated, Any

from cyclopts import Parameter

DASH = "-"
_STAND_IN = "\0-"  # no file can be called so
_BELOW_ZERO = re.compile(r"-\.?\d")
_OPTION = re.compile("--[^=]+")


def hidden(arguments: Sequence[str]) -> list[str]:
    """Return arguments with every lone "-" under its other name, and amounts with their options.

    Examples
    --------
    >>> hidden(["quality", "barge", "--from", "-60deg", "--wind", "5kn"])
    ['quality', 'barge', '--from=-60deg', '--wind', '5kn']
    """
    found: list[str] = []
    for argument in arguments:
        if found and _BELOW_ZERO.match(argument) and _OPTION.fullmatch(found[-1]):
            found[-1] += f"={argument}"
        else:
            found.append(_STAND_IN if argument == DASH else argument)
    return found


def shown(text: str) -> str:
    """Return text with "-" under its own name.

    Examples
    --------
    >>> shown(f"Unknown command {hidden(['-'])[0]}")
    'Unknown command -'
    """
    return text.replace(_STAND_IN, DASH)


def _convert(_: Any, tokens: Sequence[Any]) -> str:
    """Return what was given on the command line."""
    return shown(tokens[0].value)


Dashed = Annotated[str, Parameter(converter=_convert, metavar="PATH")]
"""A path, or "-"."""
