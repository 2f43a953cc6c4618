"""The recipe for conda asks for what the package asks for."""

import tomllib
from pathlib import Path

from ruamel.yaml import YAML

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
RECIPE = YAML(typ="safe").load((ROOT / "recipe" / "recipe.yaml").read_text("utf-8"))
CALLED = {"matplotlib": "matplotlib-base"}
"""What conda calls packages that have another name on an index for pip."""


def conda(requirement):
    """Return a requirement of pip as conda writes it."""
    name, _, least = requirement.partition(">=")
    return f"{CALLED.get(name, name)} >={least}"


def test_the_recipe_is_of_this_version_and_asks_for_the_same_packages():
    """And builds with what `pip` builds with."""
    project, asked = PROJECT["project"], RECIPE["requirements"]
    python = f"python {project['requires-python']}"
    assert RECIPE["context"]["version"] == project["version"]
    assert asked["run"] == [python, *map(conda, project["dependencies"])]
    assert asked["host"] == [python, "pip", *map(conda, PROJECT["build-system"]["requires"])]
    assert RECIPE["about"]["summary"] == project["description"]
    assert RECIPE["about"]["license"] == project["license"]


def test_the_recipe_has_the_command_and_tries_it():
    """Its test is that of the wheels."""
    (entry,) = PROJECT["project"]["scripts"].items()
    assert RECIPE["build"]["python"]["entry_points"] == [" = ".join(entry)]
    assert RECIPE["tests"][1]["script"] == PROJECT["tool"]["cibuildwheel"]["test-command"]
