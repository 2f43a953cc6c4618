"""What the times were taken on."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

PACKAGES = ("swarmgrasp", "numpy", "scipy")
CPU_INFO = Path("/proc/cpuinfo")


def machine() -> str:
    """Describe the processor and the versions; nothing that names the host.

    Examples
    --------
    >>> "Python" in machine()
    True
    """
    model = platform.machine()
    if CPU_INFO.exists():
        named = [s for s in CPU_INFO.read_text("utf-8").splitlines() if s.startswith("model name")]
        model = named[0].partition(":")[2].strip() if named else model
    versions = ", ".join(f"{name} {_version(name)}" for name in PACKAGES)
    cores = os.cpu_count()
    return (
        f"{model}, {cores} core{'s' if cores != 1 else ''}, {platform.system()}; "
        f"Python {platform.python_version()}, {versions}"
    )


def _version(name: str) -> str:
    """Return a package's version, or that there is none."""
    try:
        return version(name)
    except PackageNotFoundError:
        return "(missing)"
