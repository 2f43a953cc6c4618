"""What a scenario says of the files that it takes something from, for the schema."""

from typing import Any, Literal

from pydantic import Field

from swarmgrasp.scenario.fields import Length, Section

_PATH = "A file, relative to the scenario's own."


class OutlineFile(Section):
    """An outline in a file, instead of its vertices."""

    file: str = Field(
        description=f"{_PATH} In GeoJSON, CSV, SVG or DXF.", examples=["hull.csv", "dock.geojson"]
    )
    part: str = Field(
        "",
        description="Which of several shapes: the name of a feature, an id, a layer or a handle.",
        examples=["hull"],
    )
    scale: Length | None = Field(
        None, description="What one unit of the file is [units.length].", examples=[0.001]
    )
    tolerance: Length | None = Field(
        None,
        description="How far chords are off curves at most; a ten thousandth of the extent when "
        "left out [units.length].",
        examples=[0.05],
    )
    mirror: bool | None = Field(
        None,
        strict=True,
        description="Whether the file holds one half of a hull, both its ends on the centreline.",
    )
    coordinates: Literal["degrees", "metres"] | None = Field(
        None,
        description="Whether they are longitudes and latitudes; by their range when left out.",
    )


class RobotsFile(Section):
    """Robots in a table, one a line, instead of their list."""

    file: str = Field(
        description=f"{_PATH} CSV, its columns called as the keys of a robot; x and y are the "
        "contact.",
        examples=["tugs.csv"],
    )


class AllocationFile(Section):
    """A matrix in a file; limits, names and frame may stand there or here."""

    file: str = Field(
        description=f"{_PATH} In CSV, JSON, YAML or NumPy's own format.", examples=["tam.csv"]
    )


class LoadsFile(Section):
    """A load table in a file; the point and the frame of its moments stand here."""

    file: str = Field(
        description=f"{_PATH} CSV, in columns speed, bearing, Fx, Fy and Mz.",
        examples=["loads.csv"],
    )


def with_files(schema: dict[str, Any]) -> dict[str, Any]:
    """Return the JSON schema of a scenario that may take parts from files."""
    held = schema["properties"]
    for key, model in (("outline", OutlineFile), ("robots", RobotsFile)):
        told = model.model_json_schema()
        if key == "outline":
            own = {"$ref": held[key].pop("$ref")}
            beside = schema["$defs"]["OutlineSection"]["properties"]
            told["properties"] |= {name: beside[name] for name in ("edges", "origin", "precision")}
        else:
            own = {name: held[key].pop(name) for name in ("items", "type")}
        held[key]["anyOf"] = [own, told]
    beside = schema["$defs"]["AllocationSection"]["properties"]
    told = AllocationFile.model_json_schema()
    told["properties"] |= {name: beside[name] for name in ("limits", "names", "frame")}
    held["allocation"]["anyOf"].append(told)
    own = schema["$defs"]["WindTableSection"]["properties"]
    told = LoadsFile.model_json_schema()
    told["properties"] |= {name: own[name] for name in ("about", "frame")}
    name = {"type": "string", "description": "The file of a load table.", "examples": ["loads.csv"]}
    schema["$defs"]["WindSection"]["properties"]["table"]["anyOf"] += [told, name]
    schema["required"] = ["outline"]
    schema["anyOf"] = [{"required": ["robots"]}, {"required": ["allocation"]}]
    return schema
