"""The built-in scenarios."""

from importlib.resources import files

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.ranges import nearest_name
from swarmgrasp.scenario.reading import parse_scenario
from swarmgrasp.scenario.scenario import Scenario

_FOLDER = files("swarmgrasp.scenario") / "examples"


def example_names() -> tuple[str, ...]:
    """Return the names of the built-in scenarios, in alphabetical order.

    Examples
    --------
    >>> "deck-barge" in example_names()
    True
    """
    found = (entry.name for entry in _FOLDER.iterdir())
    return tuple(sorted(n.removesuffix(".yaml") for n in found if n.endswith(".yaml")))


def example_text(name: str) -> str:
    """Return the YAML text of a built-in scenario: a file to start from.

    Parameters
    ----------
    name : str

    Raises
    ------
    ScenarioInvalid
        If there is no such scenario; the message lists those there are.
    """
    known = example_names()
    if name not in known:
        near = nearest_name(name, list(known))
        listed = "" if near.startswith("; known") else f" Known: {', '.join(known)}"
        raise ScenarioInvalid(f"there is no built-in scenario {name[:80]!r}{near}{listed}")
    return (_FOLDER / f"{name}.yaml").read_text(encoding="utf-8")


def load_example(name: str) -> Scenario:
    """Read a built-in scenario.

    Parameters
    ----------
    name : str

    Raises
    ------
    ScenarioInvalid
        If there is no such scenario; the message lists those there are.

    Examples
    --------
    >>> load_example("rectangle-5").swarm.outline.area
    2.0
    """
    return parse_scenario(example_text(name), f"{name}.yaml")
