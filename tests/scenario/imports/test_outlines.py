"""Outlines from files of other programs: what they hold, and what is refused."""

import math
from pathlib import Path

import numpy as np
import pytest

from swarmgrasp import quality
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.scenario import convert, load_scenario, parse_scenario

CASES = Path(__file__).parents[2] / "data" / "cases" / "outline-files"
DOCK = [(0, 0), (60, 0), (60, 20), (0, 20)]
SVG = '<svg xmlns="http://www.w3.org/2000/svg" '
RING = "[[0,0],[60,0],[60,20],[0,20],[0,0]]"
HOLE = "[[20,5],[40,5],[40,15],[20,15],[20,5]]"


def polygon(*rings: str) -> str:
    """Return a Polygon as GeoJSON has it."""
    return f'{{"type":"Polygon","coordinates":[{",".join(rings)}]}}'


def feature(geometry: str, name: str = "dock") -> str:
    """Return a Feature."""
    return f'{{"type":"Feature","properties":{{"name":"{name}"}},"geometry":{geometry}}}'


def collection(*geometries: str) -> str:
    """Return a FeatureCollection."""
    features = ",".join(map(feature, geometries))
    return f'{{"type":"FeatureCollection","features":[{features}]}}'


def outline_of(folder: Path, name: str, text: str | bytes, more: str = "") -> Outline:
    """Return the outline of a scenario that takes it from a file."""
    (folder / name).write_bytes(text.encode() if isinstance(text, str) else text)
    path = folder / "asked.yaml"
    path.write_text(f"outline: {{file: {name}{more}}}\nrobots: []\n")
    return load_scenario(path).swarm.outline


def refusal(folder: Path, name: str, text: str | bytes, more: str = "") -> list[str]:
    """Return the faults of a file, without its folder."""
    with pytest.raises(ScenarioInvalid) as caught:
        outline_of(folder, name, text, more)
    return [fault.replace(f"{folder}/", "") for fault in caught.value.faults]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.csv", "x,y\n0,0\n60,0\n60,20\n0,20\n"),
        ("b.csv", "\ufeffx;y\r\n0;0\r\n60,0;0\r\n60,0;20,0\r\n0;20\r\n"),
        ("c.tsv", "# dock\n0\t0\n60\t0\n60\t20\n0\t20\n0\t0\n"),
        ("d.txt", "0 0\n60 0\n60 20\n0 20"),
        (
            "e.csv",
            "name,north [ft],east [ft]\na,0,0\nb,0,196.8503937\n"
            "c,65.6167979,196.8503937\nd,65.6167979,0",
        ),
        ("f.csv", "sep=;\n0;0;1,5\n60;0;1,5\n60;20;1,5\n0;20;1,5\n"),
        ("g.csv", "0,0 0,0\n60,0 0,0\n60,0 20,0\n0,0 20,0\n".encode("utf-16")),
        ("h.geojson", polygon(RING)),
        (
            "i.json",
            collection(
                '{"type":"Point","coordinates":[1,2]}',
                f'{{"type":"MultiPolygon","coordinates":[[{RING}]]}}',
            ),
        ),
        ("j.geojson", polygon(RING.replace("]", ",5]").replace("],5]", "]]"))),
        (
            "k.svg",
            SVG
            + 'width="3cm" viewBox="0 0 60 20"><g transform="translate(0,-20)">'
            + '<polygon points="0,20 60,20 60,0 0,0"/></g></svg>',
        ),
        ("l.svg", SVG + '><rect id="d" y="-20" width="60" height="20"/></svg>'),
    ],
)
def test_every_format_holds_the_same_dock(tmp_path: Path, name: str, text: str | bytes) -> None:
    """Separators, commas, units, rings, heights and frames of drawings lead to one outline."""
    found = outline_of(tmp_path, name, text)
    assert found.area == pytest.approx(1200.0, rel=1e-8)
    assert sorted(map(tuple, found.vertices.round(6).tolist())) == sorted(DOCK)


def test_the_files_of_the_case_are_the_dock() -> None:
    """A closed ring, in GeoJSON, and corners in CSV; UTM coordinates stay as they are."""
    for name in ("geojson.json", "outline.csv"):
        assert convert(CASES / name).scenario.swarm.outline.vertices.tolist() == [
            [float(x), float(y)] for x, y in DOCK
        ]
    local, utm = (load_scenario(CASES / name) for name in ("local.yaml", "utm.yaml"))
    assert quality(utm.swarm).value == pytest.approx(quality(local.swarm).value, rel=1e-9)
    assert utm.swarm.outline.vertices[0].tolist() == [500000.12, 4649776.22]
    for name in ("closed-ring.yaml", "closed4.yaml", "dup.yaml", "open-ring.yaml"):
        assert load_scenario(CASES / name).swarm.outline.area == 1200.0
    for name, said in (
        ("selfcross", "crosses or touches itself"),
        ("hole", "should hold 2 values"),
        ("xyz", "should hold 2 values"),
    ):
        with pytest.raises(ScenarioInvalid, match=said):
            load_scenario(CASES / f"{name}.yaml")


def test_longitudes_and_latitudes_become_metres(tmp_path: Path) -> None:
    """Distances on the plane are those on the ellipsoid within the bound that is told."""
    corners = [(10.0, 54.0), (10.002, 54.0), (10.002, 54.001), (10.0, 54.001)]
    text = polygon(str([list(c) for c in corners]))
    found = outline_of(tmp_path, "a.geojson", text)
    # radii of curvature of WGS 84 at 54 degrees, by hand: N = 6392155.3 m, M = 6377306.9 m
    east, north = 6392155.3 * math.cos(math.radians(54.0)), 6377306.9
    assert np.ptp(found.vertices[:, 0]) == pytest.approx(east * math.radians(0.002), abs=1e-3)
    assert np.ptp(found.vertices[:, 1]) == pytest.approx(north * math.radians(0.001), abs=1e-3)
    (tmp_path / "a.csv").write_text("lon,lat\n" + "\n".join(f"{x},{y}" for x, y in corners))
    told = convert(tmp_path / "a.csv")
    assert told.scenario.swarm.outline.area == found.area
    assert "no distance is off by more than 0.0002 m" in told.said[0]
    across = [(179.999, 54.0), (-179.999, 54.0), (-179.999, 54.001), (179.999, 54.001)]
    wrapped = outline_of(tmp_path, "b.geojson", polygon(str([list(c) for c in across])))
    assert wrapped.area == pytest.approx(found.area, rel=1e-5)


def test_curves_keep_their_tolerance(tmp_path: Path) -> None:
    """A circle of 4 m, by SVG and by the bulges of DXF, is off by at most what was allowed."""
    svg = SVG + '><circle id="b" r="4"/></svg>'
    for text, more in (
        (svg, ", tolerance: 0.05"),
        (svg.replace("4", "400"), ", tolerance: 5 cm, scale: 0.01"),
    ):
        found = outline_of(tmp_path, "a.svg", text, more)
        middles = 0.5 * (found.vertices + np.roll(found.vertices, 1, axis=0))
        sagitta = 4.0 - np.linalg.norm(middles, axis=1)
        assert 0.02 < sagitta.max() <= 0.05


def drawing_of(code: int, bulge: float, closed: bool = True) -> bytes:
    """Return a drawing with one polyline in millimetres or in another unit."""
    import io

    import ezdxf

    drawing = ezdxf.new()
    drawing.header["$INSUNITS"] = code
    points = [(0, 0, bulge), (60000, 0, 0), (60000, 20000, bulge), (0, 20000, 0)]
    drawing.modelspace().add_lwpolyline(
        points, format="xyb", close=closed, dxfattribs={"layer": "hull"}
    )
    written = io.StringIO()
    drawing.write(written)
    return written.getvalue().encode()


def test_drawings_in_dxf(tmp_path: Path) -> None:
    """Millimetres become metres, and a bulge an arc with the sagitta that it says."""
    assert outline_of(tmp_path, "a.dxf", drawing_of(4, 0.0)).area == pytest.approx(1200.0)
    assert outline_of(
        tmp_path, "b.dxf", drawing_of(0, 0.0), ", scale: 0.001"
    ).area == pytest.approx(1200.0)
    found = outline_of(tmp_path, "c.dxf", drawing_of(4, 0.1), ", part: hull, tolerance: 1 mm")
    assert found.vertices[:, 1].min() == pytest.approx(-3.0, abs=1e-3)  # bulge times half the chord
    (tmp_path / "open.dxf").write_bytes(drawing_of(4, 0.0, closed=False))
    said = " ".join(convert(tmp_path / "open.dxf", scale=2.0).said)
    assert "The shape is open; a straight side joins its ends." in said
    assert "One unit of the file is 2 m, though it says mm." in said
    assert "POINT" in refusal(tmp_path, "d.dxf", _with_a_point())[0]
    assert "no polyline" in refusal(tmp_path, "d.dxf", _with_a_point())[0]


def _with_a_point() -> bytes:
    """Return a drawing without a polyline."""
    import io

    import ezdxf

    drawing = ezdxf.new()
    drawing.modelspace().add_point((1, 2))
    written = io.StringIO()
    drawing.write(written)
    return written.getvalue().encode()


HALF = "x,y\n0,43.85\n2.92,35.08\n6.58,-14.62\n5.12,-84.77\n3.65,-89.15\n0,-89.15\n"


def test_halves_of_hulls(tmp_path: Path) -> None:
    """What looks like one half is mirrored where that was asked, or is told by `convert`."""
    whole = outline_of(tmp_path, "a.csv", HALF, ", mirror: true")
    assert len(whole) == 10
    assert whole.origin[0] == pytest.approx(0.0, abs=1e-12)
    assert whole.area == pytest.approx(
        2.0 * outline_of(tmp_path, "a.csv", HALF, ", mirror: false").area
    )
    assert "one half of a hull" in refusal(tmp_path, "a.csv", HALF)[0]
    told = convert(tmp_path / "a.csv")
    assert told.scenario.swarm.outline.area == whole.area
    assert "mirror image in the y axis" in told.said[-2]
    assert (
        convert(CASES / "outline.csv").scenario.swarm.outline.area == 1200.0
    )  # a rectangle may be whole
    assert (
        "no half of a hull" in refusal(tmp_path, "b.csv", "0,1\n4,1\n4,3\n1,3", ", mirror: true")[0]
    )


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        (
            "a.csv",
            "0,0\n60,abc\nnan,20\n0,inf\n",
            ["a.csv:2: outline: y", "a.csv:3: outline: x", "a.csv:4: outline: y"],
        ),
        ("a.csv", "1,5,2,5\n1,2\n", ["a.csv:2: outline: has 2 cells; there should be 4"]),
        ("a.csv", "1,0,0\n2,60,0\n3,60,20\n", ["a.csv:1: outline: counts its lines"]),
        ("a.csv", "x,z\n0,0\n", ["no column of y"]),
        ("a.csv", "x [stone],y [stone]\n0,0\n1,0\n1,1", ["'stone', which is no unit of length"]),
        ("a.csv", "0,0\n1,0\n1e308,1\n", ["a.csv:3: outline: (1e+308, 1) m is too far"]),
        ("a.csv", "", ["is empty"]),
        ("a.csv", b"\x00\x01\xff\xfe" * 9, ["is no text"]),
        ("a.csv", "0,0\n1,1\n", ["has 2 corners"]),
        ("a.csv", "1,2\n" * 20_001, ["at most 20000 are read"]),
        ("a.csv", "7" * 10_000_001, ["is too large"]),
        ("a.geojson", '{"type":"Polygon",\n"coordinates":[', ["a.geojson:2: outline: is no JSON"]),
        (
            "a.geojson",
            polygon("[[0,0],[60,0],\n[60,NaN]]"),
            ["a.geojson:2: outline.coordinates.0.2: should be [x, y]"],
        ),
        (
            "a.geojson",
            feature(polygon(RING, f"\n\t{HOLE}")),
            ["a.geojson:2:", "the polygon 'dock' has a hole"],
        ),
        (
            "a.geojson",
            f'{{"type":"MultiPolygon","coordinates":[[{RING}],[{HOLE}]]}}',
            ["the MultiPolygon has 2 polygons"],
        ),
        ("a.geojson", collection(polygon(RING), polygon(HOLE)), ["there are 2 polygons"]),
        (
            "a.geojson",
            '{"type":"LineString","coordinates":[[0,0],[1,1]]}',
            ["holds no Polygon, only LineString"],
        ),
        ("a.geojson", "[" * 100_000, ["nested too deep"]),
        ("a.geojson", "[1]", ["should be GeoJSON"]),
        ("a.json", '{"format": "swarmgrasp quality 3"}', ["is an answer, and no map"]),
        ("a.geojson", polygon("[[1" + "0" * 400 + ",0],[1,1],[0,1]]"), ["should be [x, y]"]),
        ("a.svg", "<svg>\n<path", ["a.svg:2: outline: is no XML"]),
        (
            "a.svg",
            '<!DOCTYPE a [<!ENTITY b "c">]>\n<svg>&b;</svg>',
            ["a.svg:1: outline: defines entities"],
        ),
        (
            "a.svg",
            SVG + '><path d="M0,0 L9,0 C1e308,9 -1e308,9 0,9 A1e999 2 0 0 1 0 0"/></svg>',
            ["the shape number 1 "],
        ),
        ("a.svg", "<html/>", ["should be a drawing in SVG"]),
        (
            "a.svg",
            SVG + '>\n<rect width="1" height="2"/>\n<circle id="b" r="1"/></svg>',
            ["a.svg:3: outline: holds 2 shapes, number 1, b"],
        ),
        (
            "a.svg",
            SVG + '><path id="h" d="M0,0H9V9H0ZM3,3H6V6H3Z"/></svg>',
            ["the shape h has several parts or a hole"],
        ),
        ("a.svg", SVG + "><text>no</text></svg>", ["holds no shape"]),
        ("a.dxf", "hello\nworld\n", ["cannot be read as DXF"]),
        ("a.stl", "solid", ["is no outline by its name"]),
    ],
)
def test_wrong_files_are_refused_in_words(
    tmp_path: Path, name: str, text: str | bytes, said: list[str]
) -> None:
    """Every fault is told, with the file and the line."""
    faults = refusal(tmp_path, name, text)
    assert len(faults) == len(said) or len(said) == 2
    assert all(any(part in fault for fault in faults) for part in said)


def test_faults_of_files_stand_beside_those_of_the_scenario(tmp_path: Path) -> None:
    """A bad file hides no fault of the scenario, and brings none that is not there."""
    (tmp_path / "a.csv").write_text("0,0\n1,x\n")
    path = tmp_path / "asked.yaml"
    path.write_text(
        "outline: {file: a.csv, mirror: 3, colour: red}\n"
        "robots: [{contact: [7, 7], direction: 0, limit: -1}]\n"
    )
    with pytest.raises(ScenarioInvalid) as caught:
        load_scenario(path)
    assert [fault.split(": ")[1] for fault in caught.value.faults] == [
        "outline.mirror",
        "outline.colour",
        "robots.0.limit",
        "outline",
    ]
    path.write_text("outline: {file: none.csv}\nrobots: []\n")
    with pytest.raises(
        ScenarioInvalid, match=r":1:17: outline.file: there is no such file \(got 'none.csv'\)"
    ):
        load_scenario(path)


def test_text_from_anywhere_reads_no_files() -> None:
    """Only a scenario that lies in a folder takes parts from files."""
    with pytest.raises(ScenarioInvalid, match="files are read for scenarios in files only"):
        parse_scenario("outline: {file: /etc/passwd}\nrobots: []\n")


def test_robots_from_a_table(tmp_path: Path) -> None:
    """Columns are called as the keys of a robot; a fault of one is told with its line."""
    (tmp_path / "dock.csv").write_text("0,0\n60,0\n60,20\n0,20\n")
    table = tmp_path / "tugs.csv"
    table.write_text(
        "name;x;y;edge;along;direction;limit [kN];steers;two_way\n"
        "Ajax;10;0;;;inward;600,5;;\nDione;;;1;5;180 deg;500;0,5;\n7;0;10;;;0;40;;TRUE\n"
    )
    path = tmp_path / "asked.yaml"
    path.write_text("outline: {file: dock.csv}\nrobots: {file: tugs.csv}\n")
    ajax, dione, seven = load_scenario(path).swarm
    assert (ajax.contact, ajax.limit) == ((10, 0), 600.5e3)
    assert (seven.name, seven.reverse_limit) == ("7", 40e3)
    assert (dione.contact, dione.steers) == ((60, 5), 0.5)
    assert dione.direction == pytest.approx(math.pi)
    table.write_text("name,x,y,direction,limit\na,10,0,0.5,-3\nb,10,1,left,4\n")
    with pytest.raises(ScenarioInvalid) as caught:
        load_scenario(path)
    assert [fault.replace(f"{tmp_path}/", "")[:30] for fault in caught.value.faults] == [
        "tugs.csv:2: robots.0.limit: sh",
        "tugs.csv:3: robots.1.contact: ",
        "tugs.csv:3: robots.1.direction",
    ]
    table.write_text("name [m],x,y,limit [ft]\na,10,3,2\n")
    with pytest.raises(ScenarioInvalid, match=r"'ft' is a unit of length.*\n.*'name' has no unit"):
        load_scenario(path)
    table.write_text("name,x,limt\na,10,3\n")
    with pytest.raises(ScenarioInvalid, match="did you mean 'limit'") as caught:
        load_scenario(path)
    assert "has a column x and none of y" in caught.value.faults[0]


@pytest.mark.parametrize(
    ("name", "content", "options", "said"),
    [
        ("a.csv", "0,0\n9,0\n9,9\n", {"tolerance": 0.1}, "has no curves; leave out tolerance"),
        ("a.csv", "lon,lat\n9,50\n9.001,50\n9,50.001\n", {"scale": 2.0}, "leave out scale"),
        ("a.csv", "0,0\n9,0\n9,9\n", {"part": "hull"}, "has no parts by name"),
    ],
)
def test_what_plays_no_part_is_refused(
    tmp_path: Path, name: str, content: str, options: dict[str, object], said: str
) -> None:
    """A tolerance without curves, a scale of degrees, a part of what has none."""
    (tmp_path / name).write_text(content)
    with pytest.raises(ScenarioInvalid, match=said):
        convert(tmp_path / name, **options)
