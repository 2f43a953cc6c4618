"""What the keys of a scenario file measure, from where and which way: writes scenario-frame.svg.

The picture is drawn from what the program reads of one file, once as it stands and once with
`frame: NED`: the same numbers are then the mirror image.
"""

import math
from html import escape
from pathlib import Path

from swarmgrasp.scenario import parse_scenario

FILE = """
units: {length: m, force: kN, angle: deg, speed: kn}
frame: %s
outline: {vertices: [[-30, -10], [22, -10], [30, 0], [22, 10], [-30, 10]], origin: [-4, 0]}
robots:
  - {name: A, edge: 0, along: 20, direction: inward, limit: 300}
  - {name: B, theta: 40, direction: inward, limit: 300}
  - {name: C, at: 59, direction: inward, limit: 300}
  - {name: D, contact: [-30, 5], direction: 30, limit: 300}
"""
NAMES = {
    "ENU": ("starboard", "starboard bow", "port bow", "port", "stern"),
    "NED": ("port", "port bow", "starboard bow", "starboard", "stern"),
}
TITLES = {
    "ENU": "frame: ENU, the default: y to port, counter-clockwise",
    "NED": "frame: NED: y to starboard, clockwise",
}
SCALE, WIDTH, HEIGHT = 9.0, 720, 410
STYLE = """
svg { background: #ffffff; color: #1b1f24; font: 13px sans-serif; }
text { fill: currentColor; }
.key { font-weight: 600; }
.title { font-size: 15px; font-weight: 600; }
.soft { fill: #5b6570; }
.hull { fill: #eef3f8; stroke: #1b1f24; stroke-width: 1.6; }
.axis { stroke: #5b6570; fill: #5b6570; }
.robot { stroke: #0b62b0; fill: #0b62b0; }
.length { stroke: #a8480c; fill: #a8480c; }
.angle { stroke: #14743f; fill: #14743f; }
.robot, .length, .angle, .axis { stroke-width: 1.6; }
text.robot, text.length, text.angle, text.axis { stroke: none; }
.line { fill: none !important; }
.dashed { stroke-dasharray: 4 3; }
@media (prefers-color-scheme: dark) {
  svg { background: #14181d; color: #e6e9ed; }
  .soft { fill: #a4adb8; }
  .hull { fill: #20282f; stroke: #e6e9ed; }
  .axis { stroke: #a4adb8; fill: #a4adb8; }
  .robot { stroke: #6db3f2; fill: #6db3f2; }
  .length { stroke: #f0955a; fill: #f0955a; }
  .angle { stroke: #62c48d; fill: #62c48d; }
}
"""


class Panel:
    """One picture, in the coordinates of its file."""

    def __init__(self, frame: str, top: float) -> None:
        self.parts: list[str] = []
        self.scenario = parse_scenario(FILE % frame)
        self.down = 1.0 if frame == "NED" else -1.0  # where the file's y goes on the sheet
        self.middle = top + HEIGHT / 2 + 16 + 14 * self.down

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Return where a point of the file is on the sheet."""
        return WIDTH / 2 + SCALE * x, self.middle + self.down * SCALE * y

    def line(self, points: list[tuple[float, float]], style: str, *, arrow: bool = False) -> None:
        """Draw a line through points, perhaps with an arrow at its end."""
        spots = [self.at(*point) for point in points]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in spots)
        self.parts.append(f'<polyline class="{style} line" points="{path}"/>')
        if arrow:
            (x0, y0), (x1, y1) = spots[-2:]
            way = math.atan2(y1 - y0, x1 - x0)
            tips = [(x1, y1)]
            tips += [(x1 - 9 * math.cos(way + s), y1 - 9 * math.sin(way + s)) for s in (0.4, -0.4)]
            head = " ".join(f"{x:.1f},{y:.1f}" for x, y in tips)
            self.parts.append(f'<polygon class="{style.split()[0]}" points="{head}"/>')

    def text(self, x: float, y: float, said: str, style: str = "", anchor: str = "middle") -> None:
        """Write text about a point."""
        across, down = self.at(x, y)
        self.parts.append(
            f'<text class="{style}" x="{across:.1f}" y="{down + 4.5:.1f}" '
            f'text-anchor="{anchor}">{escape(said)}</text>'
        )

    def dot(self, x: float, y: float, style: str) -> None:
        """Draw a point."""
        across, down = self.at(x, y)
        self.parts.append(f'<circle class="{style}" cx="{across:.1f}" cy="{down:.1f}" r="4"/>')

    def turn(self, centre: tuple[float, float], radius: float, ends: tuple[float, float]) -> None:
        """Draw an angle [deg] in the file's sense of turning, with its arrow."""
        first, last = ends
        steps = [math.radians(first + (last - first) * k / 40) for k in range(41)]
        x, y = centre
        arc = [(x + radius * math.cos(t), y + radius * math.sin(t)) for t in steps]
        self.line(arc, "angle", arrow=True)


def draw(frame: str, top: float) -> list[str]:
    """Return the parts of the picture of a frame."""
    panel = Panel(frame, top)
    to_file = panel.scenario.terms.frame.to_file
    corners = [(-30, -10), (22, -10), (30, 0), (22, 10), (-30, 10)]
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in (panel.at(*corner) for corner in corners))
    panel.parts.append(f'<polygon class="hull" points="{path}"/>')
    for i, (x, y) in enumerate(corners):
        panel.dot(x, y, "axis")
        side = -1.9 if i in (0, 4) else 1.2
        panel.text(x + side, y * 1.14 + (1.9 if i == 2 else 0), f"{i}", "soft")
    middles = [(-17, -8.4), (21.5, -4.6), (21.5, 4.6), (-13.5, 8.6), (-24.5, -2)]
    for i, ((x, y), name) in enumerate(zip(middles, NAMES[frame], strict=True)):
        panel.text(x, y, f"edge {i}: {name}" if i != 1 and i != 2 else f"edge {i}", "soft")
    panel.text(34.5, 0, "bow", "soft")
    _axes(panel)
    contacts = {r.name: tuple(to_file(r.contact).tolist()) for r in panel.scenario.swarm.robots}
    ways = {
        r.name: panel.scenario.terms.frame.direction_to_file(r.direction)
        for r in panel.scenario.swarm.robots
    }
    _lengths(panel, contacts)
    _angles(panel, contacts)
    for name, (x, y) in contacts.items():
        way = ways[name]
        back = (x - 6.5 * math.cos(way), y - 6.5 * math.sin(way))
        panel.line([back, (x, y)], "robot", arrow=True)
        panel.dot(x, y, "robot")
        panel.text(back[0] - 1.6 * math.sin(way), back[1] + 1.6 * math.cos(way), name, "robot key")
    panel.parts.append(f'<text class="title" x="16" y="{top + 28:.1f}">{TITLES[frame]}</text>')
    return panel.parts


def _axes(panel: Panel) -> None:
    """Draw the axes at the origin, and a torque."""
    panel.line([(-4, 0), (9, 0)], "axis", arrow=True)
    panel.line([(-4, 0), (-4, 7)], "axis", arrow=True)
    panel.dot(-4, 0, "axis")
    panel.text(10.2, 0, "x", "axis key")
    panel.text(-4, 8.2, "y", "axis key")
    panel.text(-5.2, 1.2, "origin", "soft", "end")
    panel.turn((-4, 0), 4.2, (190, 330))
    panel.text(0.6, -4.3, "tz > 0", "angle key", "start")


def _lengths(panel: Panel, contacts: dict[str, tuple[float, float]]) -> None:
    """Draw `along` and `at`."""
    (x, y), (far, off) = contacts["A"], contacts["C"]
    panel.line([(-30, y - 2.2), (x, y - 2.2)], "length", arrow=True)
    panel.text(-21, y - 3.9, "along: 20", "length key")
    out = 9.5
    corner = 22 + out * 0.45
    slope = math.hypot(8, 10)
    nx, ny = 10 / slope * out, -8 / slope * out
    panel.line([(-30, -10 - out), (corner, -10 - out), (far + nx, off + ny)], "length", arrow=True)
    panel.line([(-30, -10), (-30, -10 - out - 1)], "length dashed")
    panel.line([(far, off), (far + nx * 1.1, off + ny * 1.1)], "length dashed")
    panel.text(2, -10 - out - 1.7, "at: 59, along the boundary from vertex 0", "length key")


def _angles(panel: Panel, contacts: dict[str, tuple[float, float]]) -> None:
    """Draw `theta`, and the direction of a force."""
    x, y = contacts["B"]
    panel.line([(-4, 0), (x, y)], "angle dashed")
    panel.turn((-4, 0), 7.5, (0, 40))
    panel.text(4.8, 3.0, "theta: 40", "angle key", "start")
    x, y = contacts["D"]
    panel.line([(x, y), (x + 9, y)], "angle dashed")
    panel.line([(x, y), (x + 7 * math.cos(math.pi / 6), y + 3.5)], "angle dashed")
    panel.turn((x, y), 6.2, (0, 30))
    panel.text(x + 7.2, y + 1.5, "direction: 30", "angle key", "start")


def picture() -> str:
    """Return the picture as SVG."""
    parts = [*draw("ENU", 0.0), *draw("NED", HEIGHT)]
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {2 * HEIGHT}" role="img">'
        "<title>Outline, edges, along, at, theta and direction in both frames</title>"
    )
    return "\n".join([head, f"<style>{STYLE}</style>", *parts, "</svg>", ""])


if __name__ == "__main__":
    Path(__file__).with_name("scenario-frame.svg").write_text(picture(), encoding="utf-8")
