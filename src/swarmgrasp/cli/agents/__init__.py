"""`swarmgrasp agents`: what is done with many robots that decide for themselves."""

from cyclopts import App

from swarmgrasp.cli.agents.ask import ask
from swarmgrasp.cli.agents.curve import curve
from swarmgrasp.cli.agents.demo import demo
from swarmgrasp.cli.agents.keys import keys
from swarmgrasp.cli.agents.ros2 import ros2
from swarmgrasp.cli.agents.simulate import simulate
from swarmgrasp.cli.agents.watch import watch

COMMANDS = (ask, curve, demo, keys, ros2, simulate, watch)
HELP = "Run, watch, try and study swarms of robots that decide for themselves."


def build() -> App:
    """Return the commands about many robots, as one."""
    app = App(name="agents", help=HELP, help_epilogue="")
    for command in COMMANDS:
        app.command(command, help_epilogue="")
    return app
