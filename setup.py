"""How the kernels are built: what pyproject.toml cannot say."""

import re
import sysconfig
from pathlib import Path
from typing import Any, ClassVar

from setuptools import setup
from setuptools.command.build_ext import build_ext
from setuptools.errors import CompileError


class BuildKernels(build_ext):
    """Build with the compiler at hand, and say in one line what is missing."""

    ARITHMETIC: ClassVar = {
        "unix": ["-std=c11", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"],
        "msvc": ["/std:c11", "/O2", "/fp:precise"],
    }
    """IEEE arithmetic throughout: the last two of `unix` only forget errno and signals."""

    MISSING = (
        "swarmgrasp is built from C, and {} is missing; install a C compiler and Python's headers "
        "(Debian: gcc libc6-dev python3-dev), or take a wheel, which needs neither"
    )

    def build_extension(self, extension: Any) -> None:
        """Build one of them."""
        if not (Path(sysconfig.get_path("include")) / "Python.h").exists():
            raise CompileError(self.MISSING.format("Python.h"))
        extension.extra_compile_args = self.ARITHMETIC.get(self.compiler.compiler_type, [])
        try:
            super().build_extension(extension)
        except CompileError as fault:
            if "exit code" in str(fault):  # it ran, and has said what is wrong
                raise
            raise CompileError(self.MISSING.format("a C compiler that runs")) from None


def readme() -> str:
    """Return the README as an index shows it: without pictures and links into the sources.

    There is no address yet that they could lead to.
    """
    parts = re.split(r"(^```.*?^```$)", Path("README.md").read_text("utf-8"), flags=re.M | re.S)
    for k, part in enumerate(parts):
        if not part.startswith("```"):
            shown = re.sub(r"^!\[[^\]]*\]\((?!https?:)[^)]*\)\n+", "", part, flags=re.M)
            parts[k] = re.sub(r"\[([^\]]+)\]\((?!https?:)[^)]*\)", r"\1", shown)
    return "".join(parts)


setup(
    cmdclass={"build_ext": BuildKernels},
    long_description=readme(),
    long_description_content_type="text/markdown",
)
