"""Warnings at the line of code outside of this package that led to them.

Python 3.12 can skip files of some prefixes for that; 3.11 cannot, so it is done here by hand.
"""

import sys
from warnings import warn

_MAKING = {"__init__", "__post_init__", "replace", "_replace"}
"""What runs while somebody makes an object of a class, or another with a changed field."""


def warn_caller(said: str, category: type[Warning], *, is_of_maker: bool = False) -> None:
    """Warn at the line that led to a call of this package.

    Parameters
    ----------
    said : str
    category : type of Warning
    is_of_maker : bool
        Whether the warning is for who makes an object alone: nothing is said if code of this
        package makes it.
    """
    frame, level, passed = sys._getframe(1), 2, set[str]()
    while frame.f_back is not None and _is_passed(str(frame.f_globals.get("__name__"))):
        passed.add(frame.f_code.co_name)
        frame, level = frame.f_back, level + 1
    if not is_of_maker or passed <= _MAKING:
        warn(said, category, stacklevel=level)


def _is_passed(module: str) -> bool:
    """Tell whether a module is no place to warn at: one of ours, or one that makes our objects."""
    return module.split(".")[0] in ("swarmgrasp", "dataclasses")
