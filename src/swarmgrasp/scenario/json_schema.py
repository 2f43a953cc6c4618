"""The JSON schema of a scenario file, for editors."""

from typing import Any

from swarmgrasp.scenario.imports.keys import with_files
from swarmgrasp.scenario.schema import ScenarioFile

_EXAMPLE = {
    "name": "Barge",
    "units": {"length": "m", "force": "kN", "angle": "deg", "speed": "kn"},
    "frame": "ENU",
    "bow": "+x",
    "heading": "NE",
    "words": "tug",
    "outline": {
        "vertices": [[0, 0], [4, 0], [4, 2], [0, 2]],
        "edges": ["starboard", "bow", "port", "stern"],
    },
    "robots": [
        {
            "name": "Ajax",
            "edge": "stern",
            "along": 1.5,
            "direction": "inward",
            "limit": 60,
            "steers": 30,
        },
        {"name": "Hector", "contact": [4, 0.5], "direction": "3 rad", "limit": "6 t"},
    ],
    "newcomer": {"limit": 60, "attachment": "push", "half_angle": 30},
    "zones": [{"edge": "port", "from": 0.5, "to": 3.5}, {"contact": [4, 2], "attachment": "pull"}],
    "no_go": [{"edge": "starboard"}],
    "spacing": 0.2,
    "tolerance": {"contact": 0.2, "direction": [-5, 10], "least_limit": 50},
    "criterion": {"losing": 1, "worst_case": True, "load": [0, -5, 0]},
    "environment": {
        "wind": {
            "vessel": "tender",
            "frontal_area": 6,
            "lateral_area": 20,
            "speed": 1,
            "from": "225 true",
        },
        "current": {"frontal_area": 2, "lateral_area": 4, "speed": 0.5},
    },
    "simulation": {
        "duration": 300,
        "robots": {"lag": 0.5, "except": [{"name": "Ajax", "efficiency": 0.9}]},
        "weather": {"gusts": "npd"},
        "events": [
            {"at": 60, "lose": "Ajax", "noticed": 5},
            {"at": 65, "send": "newcomer", "away": 40, "speed": 0.5, "make_fast": 10},
            {"at": 70, "send": {"name": "Gyges", "limit": 30, "attachment": "push"}},
            {"at": 200, "move": [1, 0, 5]},
            {"at": 250, "wind": {"speed": 2}, "current": {"from": 90}},
        ],
    },
}


def scenario_schema() -> dict[str, Any]:
    """Return the JSON schema of a scenario file, draft 2020-12, for editors.

    Examples
    --------
    >>> scenario_schema()["required"]
    ['outline']
    """
    schema: dict[str, Any] = _tidied(with_files(ScenarioFile.model_json_schema()))
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **schema,
        "title": "swarmgrasp scenario",
        "examples": [_EXAMPLE],
    }


def _tidied(schema: Any) -> Any:
    """Return a schema without nulls, which stand for "left out", and without class names."""
    if isinstance(schema, list):
        return [_tidied(part) for part in schema if part != {"type": "null"}]
    if not isinstance(schema, dict):
        return schema
    kept = {
        key: _tidied(part)
        for key, part in schema.items()
        if not (key == "default" and part is None)
        and not (key == "title" and isinstance(part, str))
    }
    if len(kept.get("anyOf", "..")) == 1:
        (only,) = kept.pop("anyOf")
        kept = {**only, **kept}
    return kept
