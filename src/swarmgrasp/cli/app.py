"""The application: its commands, its help, and what its exit status means."""

import io
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

from cyclopts import App, CycloptsError
from cyclopts.help import DefaultFormatter, PanelSpec

from swarmgrasp.cli import agents
from swarmgrasp.cli.agent import agent
from swarmgrasp.cli.capability import capability
from swarmgrasp.cli.convert import convert
from swarmgrasp.cli.count import count
from swarmgrasp.cli.dash import hidden, shown
from swarmgrasp.cli.examples import examples
from swarmgrasp.cli.forces import forces
from swarmgrasp.cli.judge import judge
from swarmgrasp.cli.lasting import INTERRUPTED
from swarmgrasp.cli.move import move
from swarmgrasp.cli.paper import paper
from swarmgrasp.cli.place import place
from swarmgrasp.cli.plot import plot
from swarmgrasp.cli.quality import quality
from swarmgrasp.cli.report import report
from swarmgrasp.cli.schema import schema
from swarmgrasp.cli.show.report import complain
from swarmgrasp.cli.simulate import simulate
from swarmgrasp.cli.studio import studio
from swarmgrasp.cli.study import study
from swarmgrasp.cli.verify import verify
from swarmgrasp.errors import SwarmGraspError

WRONG_INPUT = 2
COMMANDS = (
    place, move, count, quality, forces, capability, simulate, study, verify, judge, plot, report,
    studio, agent, paper, examples, convert, schema,
)  # fmt: skip
USAGES = {
    "examples": "Usage: swarmgrasp examples [OPTIONS] [NAME]",
    "studio": "Usage: swarmgrasp studio [OPTIONS] [FILE]",
}
"""Of commands whose argument may be left out."""
READER_LEFT = 141
"""What a shell reports for a program whose reader closed the pipe, as `head` does."""

HELP = """
Where should the next robot attach to a large object, and which way should it push?

The answer is the best of all allowed contacts and directions, with a proof that
anybody can check again.

- Try an example: `swarmgrasp place deck-barge`
- Start a file of your own: `swarmgrasp examples deck-barge > my.yaml`
- Ask about one command: `swarmgrasp place --help`

FILE is a scenario in YAML, an answer in JSON whose question is asked again, "-" for standard
input, or the name of a built-in example when there is no such file. Answers come in the units and
the frame of the file, with angles in degrees; `--units si` tells metres and newtons, `--bearings`
directions clockwise from the bow. So are numbers that options give; those with a unit, such as 60t,
25kn or 90deg, are in that. JSON is in SI units and radians.
"""

STATUS = """
Exit status: 0 done; 1 an answer was refused (verify, judge, report), an object was not held
(simulate), a statement does not hold (paper, agents curve), an invariant broke (agents simulate),
places differ (agents demo) or a robot cannot do what is asked (agents ask); 2 wrong input or usage;
130 interrupted with Ctrl-C.
"""


def build() -> App:
    """Return the application, its help laid out for where it goes."""
    app = App(
        name="swarmgrasp",
        help=HELP,
        help_epilogue=STATUS,
        help_format="markdown",
        help_formatter=_without_boxes(),
        version=_version,
        suppress_keyboard_interrupt=False,
        exit_on_error=False,
        print_error=False,
        result_action="return_value",
    )
    for command in COMMANDS:
        # cyclopts would call an argument that may be left out [ARGS]
        usage = USAGES.get(command.__name__)
        app.command(command, help_epilogue="", usage=usage)
    app.command(agents.build())
    app.register_install_completion_command()
    return app


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command.

    Parameters
    ----------
    arguments : sequence of str, optional
        Those of the process when left out.

    Returns
    -------
    int
        The exit status.
    """
    given = hidden(sys.argv[1:] if arguments is None else arguments)
    if not _has_streams():
        return WRONG_INPUT
    if isinstance(sys.stdout, io.TextIOWrapper):  # a name must not break an ASCII terminal
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        status = build()(given)
        sys.stdout.flush()
    except CycloptsError as error:
        command = _command_of(given)
        complain(
            [shown(str(error)), f"For help: swarmgrasp {command + ' ' if command else ''}--help"]
        )
        return WRONG_INPUT
    except SwarmGraspError as error:
        complain(map(shown, error.faults))
        return WRONG_INPUT
    except KeyboardInterrupt:
        return INTERRUPTED
    except (BrokenPipeError, SystemExit):  # rich, which writes the help, turns one into the other
        # Python flushes once more as it ends; let that go nowhere
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return READER_LEFT
    except OSError as error:
        complain([f"{error.filename or 'the output'}: cannot be written: {error.strerror}"])
        return WRONG_INPUT
    return status if isinstance(status, int) else 0


def run() -> NoReturn:
    """Run the process's command."""
    sys.exit(main())


def _command_of(given: Sequence[str]) -> str:
    """Return the command that arguments begin with; "" if they begin with none."""
    known = {command.__name__ for command in COMMANDS} | {"agents"}
    within = {command.__name__ for command in agents.COMMANDS}
    words = [word for word in given[:1] if word in known]
    if words == ["agents"]:
        words += [word for word in given[1:2] if word in within]
    return " ".join(words)


def _has_streams() -> bool:
    """Tell whether there is a standard output; complain if not, and see to a standard error."""
    if sys.stderr is None:  # what is printed there would go to standard output
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115
    if sys.stdout is None:
        complain(["standard output is closed; send it to a file, or to /dev/null"])
    return sys.stdout is not None


def _without_boxes() -> DefaultFormatter:
    """Return a layout of help whose panels have no frames, for terminals and pipes alike."""
    from rich.box import Box

    return DefaultFormatter(panel_spec=PanelSpec(box=Box("    \n" * 8), padding=(0, 0)))


def _version() -> str:
    """Return the version of the program."""
    from importlib.metadata import version

    return version("swarmgrasp")
