"""The page: everything the program knows of a scenario, to be seen and moved.

Importing this imports no server and no notebook.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swarmgrasp.environment import Environment
    from swarmgrasp.gui.notebook import Studio
    from swarmgrasp.placement import Problem
    from swarmgrasp.scenario import Scenario

__all__ = ["studio"]


def studio(
    asked: "Problem | Scenario | str",
    *,
    name: str = "",
    environment: "Environment | None" = None,
) -> "Studio":
    """Show a scenario in a notebook, to be dragged: what is changed there comes back.

    Parameters
    ----------
    asked : Problem, Scenario or str
        A question; or the name of a built-in scenario.
    name : str
        A title for a problem.
    environment : Environment, optional
        What is around the object of a problem.

    Returns
    -------
    Studio
        A widget of Jupyter and marimo: its `problem` follows what is dragged, `quality` and `place`
        the answer.

    Raises
    ------
    PackageMissing
        Without the packages of the extra `notebook`.
    ScenarioInvalid
        If a scenario file cannot say the problem, or no built-in scenario has the name.
    """
    from swarmgrasp.packages import check_installed

    check_installed("anywidget", "msgspec", extra="notebook", purpose="A page in a notebook")
    from swarmgrasp.gui.notebook import Studio, text_of

    title, text = text_of(asked, name, environment)
    return Studio(title, text)
