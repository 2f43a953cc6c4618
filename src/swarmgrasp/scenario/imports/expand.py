"""Put into a document what it takes from other files: an outline, robots, a matrix, loads."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import unknown_key
from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.faults import Faults, Mark
from swarmgrasp.scenario.faults import Path as Keys
from swarmgrasp.scenario.imports.allocation import Matrix, read_allocation
from swarmgrasp.scenario.imports.hull import Hull
from swarmgrasp.scenario.imports.loads import read_loads
from swarmgrasp.scenario.imports.outlines import DETECT, Wish, read_outline
from swarmgrasp.scenario.imports.robots import read_robots
from swarmgrasp.scenario.imports.source import Source
from swarmgrasp.units import canonical, quantity
from swarmgrasp.words import list_words

OUTLINE_OPTIONS = ("part", "scale", "tolerance", "mirror", "coordinates")
"""Keys beside `file` that say how an outline is to be understood."""
OUTLINE_BESIDE = ("edges", "origin", "precision")
"""And those that an outline has wherever its corners come from."""
_FILE = "file"
LARGEST = 1e9
"""A scale or a tolerance is no larger."""


Folder = Path | Mapping[str, Path] | None
"""Where what a document takes from files is."""


class Taken(NamedTuple):
    """What became of what a document takes from files.

    Attributes
    ----------
    stand_ins : set of tuple
        Paths to stand-ins, for files with faults.
    said : tuple of str
        What was assumed, sentences.
    bow : str
        The axis along which a mirrored half of a hull is pointed; "" if nothing is known.
    """

    stand_ins: set[Keys]
    said: tuple[str, ...] = ()
    bow: str = ""


def expand(root: Node, faults: Faults, folder: Folder) -> Taken:
    """Replace what a document takes from files by what they hold, in place.

    Parameters
    ----------
    root : Node
    faults : Faults
        Receives what is wrong with the files.
    folder : Path, mapping of str to Path, or None
        That paths are relative to, or the only paths that may be said with where they are; None
        where files may not be read.

    Returns
    -------
    Taken
    """
    stand_ins, said, bow = set[Keys](), tuple[str, ...](), ""
    if _names_file(root, "outline"):
        hull = _outline(root, faults, folder)
        if hull is None:
            stand_ins.add(("outline", "vertices"))
        else:
            said, bow = hull.said, hull.bow
    held: Any = root.value
    if "allocation" in held and "robots" not in held:
        held["robots"] = Node(held["allocation"].mark, [])
    if _names_file(root, "allocation"):
        matrix = _allocation(root, faults, folder)
        said += matrix.said if matrix else ()
        stand_ins |= set() if matrix else {("allocation",)}
    _loads(root, faults, folder)
    if _names_file(root, "robots") and not _robots(root, faults, folder):
        stand_ins.add(("robots",))
    return Taken(stand_ins, said, bow)


def _names_file(root: Node, key: str) -> bool:
    """Tell whether a key holds a mapping that names a file."""
    held = root.value.get(key) if isinstance(root.value, dict) else None
    return held is not None and isinstance(held.value, dict) and _FILE in held.value


def _outline(root: Node, faults: Faults, folder: Folder) -> Hull | None:
    """Put the corners of a file into an outline; after a fault, those of a stand-in."""
    node = root.find(("outline",))
    held: Any = node.value
    keys: Keys = ("outline",)
    known = (_FILE, *OUTLINE_OPTIONS, *OUTLINE_BESIDE)
    if "vertices" in held:
        faults.add(node.key_marks[_FILE], (*keys, _FILE), "vertices and file each say it; keep one")
    path = _path(held[_FILE], (*keys, _FILE), faults, folder)
    wish = _wish(node, keys, length_unit(root), faults)
    for key in [k for k in held if k not in (*known, "vertices")]:
        faults.add(node.key_marks[key], (*keys, key), unknown_key(key, known))
        del held[key]
    for key in (_FILE, *OUTLINE_OPTIONS):
        held.pop(key, None)
    hull = None
    if path is not None and "vertices" not in held:
        source = Source(path, faults, keys)
        hull = read_outline(source, length_unit(root), wish or Wish(mirror=DETECT))
    if hull is not None and hull.unit == "deg" and root.find(("frame",)).value == "NED":
        hull = None
        said = "is in degrees: x runs to the east and y to the north, as in no frame: NED"
        faults.add(node.key_marks[_FILE], (*keys, _FILE), said)
    if hull is None or wish is None:
        held.setdefault("vertices", _stand_in(node))
        return None
    mark = node.mark
    held["vertices"] = Node(mark, [_row(point, mark) for point in hull.points])
    node.key_marks["vertices"] = node.key_marks[_FILE]
    return hull


def _allocation(root: Node, faults: Faults, folder: Folder) -> Matrix | None:
    """Put the matrix of a file into a document, and what else it says of it; None after a fault."""
    node, keys = root.find(("allocation",)), ("allocation",)
    held: Any = node.value
    before = len(faults)
    if "matrix" in held:
        faults.add(node.key_marks[_FILE], (*keys, _FILE), "matrix and file each say it; keep one")
    path = _path(held.pop(_FILE), (*keys, _FILE), faults, folder)
    found = None if path is None else read_allocation(Source(path, faults, keys), length_unit(root))
    if found is None or len(faults) > before:
        del root.value[keys[0]]  # type: ignore[union-attr, arg-type]
        return None
    told = {
        "matrix": found.rows,
        "limits": found.limits,
        "names": found.names,
        "frame": found.frame,
    }
    for key, value in told.items():
        if value and key not in held:
            held[key] = noded(value, node.mark)
    return found


def _loads(root: Node, faults: Faults, folder: Folder) -> None:
    """Put the rows of a file into the table of a wind; after a fault, drop the environment."""
    keys: Keys = ("environment", "wind", "table")
    wind: Any = root.find(keys[:-1])
    table = wind.value.get("table") if isinstance(wind.value, dict) else None
    if table is not None and isinstance(table.value, str):
        node = Node(table.mark, {_FILE: table}, key_marks={_FILE: table.mark})
        wind.value["table"] = table = node
    if table is None or not isinstance(table.value, dict) or _FILE not in table.value:
        return
    held = table.value
    if "rows" in held:
        faults.add(table.key_marks[_FILE], (*keys, _FILE), "rows and file each say it; keep one")
    path = _path(held.pop(_FILE), (*keys, _FILE), faults, folder)
    found = None if path is None else read_loads(Source(path, faults, keys))
    if found is None:
        del root.value["environment"]  # type: ignore[union-attr, arg-type]
    elif "rows" not in held:
        held["rows"] = Node(table.mark, found)


def _robots(root: Node, faults: Faults, folder: Folder) -> bool:
    """Put the robots of a file into a document, or none; tell whether the file was sound."""
    node, keys = root.find(("robots",)), ("robots",)
    held: Any = node.value
    others = [key for key in held if key != _FILE]
    for key in others:
        faults.add(node.key_marks[key], (*keys, key), unknown_key(key, (_FILE,)))
    path = _path(held[_FILE], (*keys, _FILE), faults, folder)
    found = None if path is None else read_robots(Source(path, faults, keys))
    node.value = found or []
    return found is not None


def _stand_in(node: Node) -> Node:
    """Return corners that hide no faults of what else is in a document."""
    return Node(node.mark, [_row(p, node.mark) for p in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))])


def noded(value: Any, mark: Mark = (0, 0)) -> Node:
    """Return plain data as a document has it, all at one place."""
    if isinstance(value, dict):
        children = {key: noded(child, mark) for key, child in value.items()}
        return Node(mark, children, key_marks=dict.fromkeys(children, mark))
    if isinstance(value, list):
        return Node(mark, [noded(child, mark) for child in value])
    return Node(mark, value, str(value))


def _row(numbers: tuple[float, ...], mark: Mark) -> Node:
    """Return numbers as a list of a document."""
    return Node(mark, [Node(mark, value, repr(value)) for value in numbers])


def _path(node: Node, keys: Keys, faults: Faults, folder: Folder) -> Path | None:
    """Return the path that a value is; None after a fault."""
    if not isinstance(node.value, str) or not node.value or "\0" in node.value:
        faults.add(node.mark, keys, f"should be the path of a file (got {node.shown()})")
    elif folder is None:
        faults.add(
            node.mark, keys, "files are read for scenarios in files only; give what it holds"
        )
    elif isinstance(folder, Mapping):
        if node.value in folder:
            return folder[node.value]
        known = f"only {list_words(list(folder))} may be read" if folder else "no file may be read"
        faults.add(node.mark, keys, f"{known} here; give what it holds (got {node.shown()})")
    elif not (folder / node.value).exists():
        faults.add(node.mark, keys, f"there is no such file (got {node.shown()})")
    else:
        return folder / node.value
    return None


def files_named(root: Node) -> list[str]:
    """Return the paths of all files that a document takes something from."""
    keys = [key for key in ("outline", "allocation", "robots") if _names_file(root, key)]
    found = [root.find((key, _FILE)).value for key in keys]
    wind = root.find(("environment", "wind"))
    if _names_file(wind, "table"):
        found.append(wind.find(("table", _FILE)).value)
    elif isinstance(wind.value, dict) and "table" in wind.value:
        found.append(wind.value["table"].value)
    return [path for path in found if isinstance(path, str)]


def length_unit(root: Node) -> str:
    """Return the document's unit of length; the metre where what it says is none."""
    said = root.find(("units", "length")).value
    return (canonical(said, "length") if isinstance(said, str) else None) or "m"


def _wish(node: Node, keys: Keys, unit: str, faults: Faults) -> Wish | None:
    """Return how an outline is to be understood; None after a fault."""
    checks: dict[str, tuple[Callable[[Any], Any], str]] = {
        "part": (lambda v: v if isinstance(v, str) and v else None, "the name of a part"),
        "scale": (lambda v: _positive(v, ""), f"a number 0 < scale <= {LARGEST:g}"),
        "tolerance": (lambda v: _positive(v, unit), f"0 < tolerance <= {LARGEST:g} {unit}"),
        "mirror": (lambda v: v if isinstance(v, bool) or v is DETECT else None, "true or false"),
        "coordinates": (
            lambda v: v if v in ("degrees", "metres") else None, "degrees or metres",
        ),
    }  # fmt: skip
    held: Any = node.value
    found, sound = dict[str, Any](), True
    for key, (taken, words) in checks.items():
        if key not in held:
            continue
        found[key] = taken(held[key].value)
        if found[key] is None:
            said = f"should be {words} (got {held[key].shown()})"
            faults.add(held[key].mark, (*keys, key), said)
            sound = False
    return Wish(**found) if sound else None


def _positive(value: Any, unit: str) -> float | None:
    """Return a positive number, or a length in a unit; None if it is none."""
    try:
        found = quantity(value, "length", unit) / quantity(1.0, "length", unit) if unit else value
    except QuantityInvalid:
        return None
    is_number = isinstance(found, int | float) and not isinstance(found, bool)
    return float(found) if is_number and 0.0 < found <= LARGEST else None
