"""A lone "-" on the command line: standard input, or standard output.

Cyclopts takes it for an option, unless a parameter accepts everything that begins with a
hyphen, mistyped options included. So a lone "-" is parsed under another name.
"""

from collections.abc import Sequence
from typing import Annotated, Any

from cyclopts import Parameter

DASH = "-"
_STAND_IN = "\0-"  # no file can be called so


def hidden(arguments: Sequence[str]) -> list[str]:
    """Return arguments with every lone "-" under its other name."""
    return [_STAND_IN if argument == DASH else argument for argument in arguments]


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
