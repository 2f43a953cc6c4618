"""The kernels are compiled at the first run: a word of patience, and both processors at it."""

import subprocess
import sys
from pathlib import Path
from typing import Any

NOTICE = "compiling the kernels, once: a few seconds ..."
ELSEWHERE = "from swarmgrasp.kernels.place import compile_ahead; compile_ahead()"


def prepare_kernels(*, placing: bool) -> None:
    """Compile the kernels unless they are cached, and say so on standard error.

    Parameters
    ----------
    placing : bool
        Whether a newcomer is to be placed; a quality alone takes fewer kernels.
    """
    from swarmgrasp.kernels import facets

    missing = [not is_cached(facets.list_facets), False]
    if placing:
        from swarmgrasp.kernels.place import solve

        missing[1] = not is_cached(solve)
    if not any(missing):
        return
    print(NOTICE, file=sys.stderr, flush=True)
    # The larger half goes to a second process, through the cache; if it fails, the first call
    # of the kernel compiles it here.
    other = None
    if missing[1]:
        other = subprocess.Popen(
            [sys.executable, "-c", ELSEWHERE], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
    if missing[0]:
        facets.compile_ahead()
    if other:
        other.wait()


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
