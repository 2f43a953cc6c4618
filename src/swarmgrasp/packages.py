"""Packages that only some commands need, each of an extra of this one."""

from importlib.util import find_spec

from swarmgrasp.errors import PackageMissing


def check_installed(*modules: str, extra: str = "agents", purpose: str) -> None:
    """Raise if a package that is needed is not installed.

    Parameters
    ----------
    *modules : str
        As they are imported.
    extra : str
        Which extra of this package brings them.
    purpose : str
        What they are needed for, as the start of a sentence.

    Raises
    ------
    PackageMissing
        If one of them cannot be imported.

    Examples
    --------
    >>> check_installed("no_such_module", purpose="An example")
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.PackageMissing: An example needs no_such_module; install it with: pip install 'swarmgrasp[agents]'
    """  # noqa: E501
    missing = [module for module in modules if find_spec(module) is None]
    if missing:
        *others, last = missing
        named = f"{', '.join(others)} and {last}" if others else last
        raise PackageMissing(
            f"{purpose} needs {named}; install it with: pip install 'swarmgrasp[{extra}]'"
        )
