"""`swarmgrasp studio`: a page where everything can be seen and moved."""

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import STDIN, UsageFault, is_written, read_stdin, whole_faults
from swarmgrasp.cli.lasting import INTERRUPTED, end_on_signals, say

if TYPE_CHECKING:
    from swarmgrasp.studio.scenes import Source

DEFAULT = "escort-ring"
"""The scene opened unless told otherwise."""


def studio(
    file: Dashed = DEFAULT,
    /,
    *,
    port: Annotated[str, Parameter(metavar="INT")] = "0",
    browser: bool = True,
) -> int:
    """Open a page where tugs are dragged and the certified answer follows.

    Serves a page on this machine and prints its link, with a key that nobody else knows; Ctrl-C
    ends it. It listens at 127.0.0.1 and loads nothing from anywhere else.

    Example: swarmgrasp studio deck-barge

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example; escort-ring unless given.
    port
        Where to listen; any that is free unless given.
    browser
        Open the page in a browser.
    """
    from swarmgrasp.packages import check_installed

    check_installed(
        "msgspec", "starlette", "uvicorn", "websockets", extra="studio", purpose="The page"
    )
    faults = whole_faults("--port", port, 0, 65535)
    if faults:
        raise UsageFault(faults)
    from swarmgrasp.cli.report import html_of
    from swarmgrasp.studio.scenes import built_in
    from swarmgrasp.studio.server import Settings, opened

    scenes = built_in()
    name, scenes[name] = _scene(file, scenes)
    try:
        serving = opened(Settings(scenes, name, port=int(port), reporting=html_of))
    except OSError as error:
        raise UsageFault(
            f"port {port} of 127.0.0.1 cannot be listened at: {error.strerror}"
        ) from None
    say(serving.link)
    if browser and _has_display():
        import webbrowser

        webbrowser.open(serving.link)
    end_on_signals(serving.end)
    serving.run()
    return INTERRUPTED


def _scene(file: str, known: "dict[str, Source]") -> "tuple[str, Source]":
    """Return the scene of a command line: its name and its text."""
    from swarmgrasp.answer_file import LARGEST_FILE
    from swarmgrasp.ranges import nearest_name
    from swarmgrasp.studio.scenes import Source

    if file == DASH:
        return STDIN, Source(read_stdin(LARGEST_FILE).decode())
    if is_written(file):
        return Path(file).stem, Source(Path(file).read_text(encoding="utf-8"), Path(file).parent)
    if file not in known:
        raise UsageFault(
            f"{file}: no such file, and no built-in example{nearest_name(file, list(known))}"
        )
    return file, known[file]


def _has_display() -> bool:
    """Tell whether a browser would have a window: without one, some open in the terminal."""
    if sys.platform in {"darwin", "win32"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
