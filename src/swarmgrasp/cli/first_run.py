"""A word of patience before the kernels are compiled for the first time."""

import sys
from pathlib import Path
from typing import Any

NOTICE = "compiling the kernels, once: a few seconds ..."


def announce_compilation(*, placing: bool) -> None:
    """Say on standard error that kernels will be compiled, unless they are cached.

    Parameters
    ----------
    placing : bool
        Whether a newcomer is to be placed; a quality alone takes fewer kernels.
    """
    from swarmgrasp.kernels.facets import list_facets

    kernels: list[Any] = [list_facets]
    if placing:
        from swarmgrasp.kernels.place import solve

        kernels.append(solve)
    if not all(is_cached(kernel) for kernel in kernels):
        print(NOTICE, file=sys.stderr, flush=True)


def is_cached(kernel: Any) -> bool:
    """Tell whether Numba finds a kernel's index of compiled code, newer than its source.

    An index carries the function's name and first line and the version of Python.
    """
    if kernel.stats.cache_path is None:  # there is no folder that may be written to
        return False
    code = kernel.py_func.__code__
    python = f"py{sys.version_info.major}{sys.version_info.minor}"
    name = f"*{kernel.py_func.__qualname__}-{code.co_firstlineno}.{python}*.nbi"
    try:
        source = Path(code.co_filename).stat().st_mtime
        found = Path(kernel.stats.cache_path).glob(name)
        return any(index.stat().st_mtime >= source for index in found)
    except OSError:
        return False
