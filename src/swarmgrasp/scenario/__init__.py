"""The scenario file: what is asked, in YAML 1.2, with every fault told at once."""

from swarmgrasp.scenario.convert import Converted, convert
from swarmgrasp.scenario.editing import edited
from swarmgrasp.scenario.examples import example_names, example_text, load_example
from swarmgrasp.scenario.json_schema import scenario_schema
from swarmgrasp.scenario.reading import load_scenario, named_files, parse_scenario
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.writing import scenario_text, write

__all__ = [
    "Converted",
    "Scenario",
    "convert",
    "edited",
    "example_names",
    "example_text",
    "load_example",
    "load_scenario",
    "named_files",
    "parse_scenario",
    "scenario_schema",
    "scenario_text",
    "write",
]
