"""A run as an animated picture, by Pillow alone.

Every picture is drawn twice as large and shrunk, so that lines are smooth, and painted with the few
colours that all of them share: frames that differ little then take little room.
"""

import math
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from swarmgrasp.files import scratch_for
from swarmgrasp.simulation.export import colours
from swarmgrasp.simulation.export.scene import Film, Pusher, Scene, Vector, placed
from swarmgrasp.simulation.run import Run
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI, Terms

FRAMES: Final = 120
"""Pictures of an animation, at most."""
SHOWN: Final = 90
LAST: Final = 2000
"""How long a picture is shown, and the last one [ms]."""
LARGER: Final = 2
"""How many times larger pictures are drawn than they are shown."""
ROOM: Final = 0.36
"""Around what the object covers, relative to its extent: for robots and their names."""
ARROW: Final = 0.2
"""Length of the arrow of the largest limit, relative to the object's extent."""
HEADER: Final = 44
FOOTER: Final = 18
"""Heights of the lines of text and of the scale [px]."""
TALLEST: Final = 1.0
"""Height of the view, relative to its width, at most."""
INKS: Final = (colours.BLUE, colours.ORANGE, colours.VERMILION, colours.INK, colours.GREY)
FADES: Final = (1.0, 0.8, 0.6, 0.4, 0.2)
"""The colours of lines and text, and how far each fades into white where they are smooth."""
FILLS: Final = ("#FFFFFF", colours.WATER, colours.OBJECT, colours.WAY)
"""The colours of areas, which are those of most of a picture."""


def write_gif(
    run: Run,
    path: str | Path,
    *,
    index: int = 0,
    width: int = 480,
    frames: int = FRAMES,
    terms: Terms = SI,
) -> Path:
    """Write one of the runs as an animated GIF, whole or not at all.

    Parameters
    ----------
    run : Run
    path : str or Path
    index : int
        Which of the runs.
    width : int [px]
    frames : int
        Pictures, at most.
    terms : Terms
        The units and the frame of what is written on them.

    Returns
    -------
    Path
    """
    film, target = Film(run, index), Path(path)
    view = View(film, width, terms)
    instants = list(film.picked(frames))
    pictures = [view.picture(film.at(i), i) for i in instants]
    palette = _palette()
    first, *others = (p.quantize(palette=palette, dither=Image.Dither.NONE) for p in pictures)
    shown = [SHOWN] * len(others) + [LAST]
    with scratch_for(target) as scratch:
        first.save(scratch, save_all=True, append_images=others, duration=shown, loop=0)
    return target


def _palette() -> Image.Image:
    """Return a picture with the colours that all share, and what lies between them and white."""
    fades = [(colour, share) for colour in INKS for share in FADES]
    fades += [(colour, 1.0) for colour in FILLS]
    flat = [
        round(255.0 * (1.0 - share * (1.0 - part)))
        for colour, share in fades
        for part in colours.shares(colour)
    ]
    found = Image.new("P", (1, 1))
    found.putpalette([*flat, *(256 * 3 - len(flat)) * [255]])
    return found


class View:
    """Where things are on the pictures of a film.

    Parameters
    ----------
    film : Film
    width : int [px]
        Of a picture.
    terms : Terms
    """

    def __init__(self, film: Film, width: int, terms: Terms) -> None:
        swarm = film.run.simulation.problem.swarm
        self._film = film
        tell = Telling.of(terms, swarm.outline.extent, [swarm.limits.max(initial=0.0)])
        self._tell = replace(tell, force=replace(tell.force, figures=3))
        self._vertices = swarm.outline.vertices - film.origin
        extent = swarm.outline.extent
        low, high = film.box()
        low, high = low - ROOM * extent, high + ROOM * extent
        low[1] = max(low[1], 0.5 * (low[1] + high[1] - TALLEST * (high[0] - low[0])))
        self._extent, self._low = extent, low
        self._scale = LARGER * width / float(high[0] - low[0])
        height = min(float(high[1] - low[1]), TALLEST * float(high[0] - low[0]))
        self._floor = int(self._scale * height) + LARGER * HEADER
        self._size = LARGER * width, self._floor + LARGER * FOOTER
        self._decimals = max(0, tell.length.decimals - 1)
        limits = [robot.limit for robot in film.robots.values()]
        self._longest = ARROW * extent / max(limits, default=1.0)
        self._fonts = [ImageFont.load_default(LARGER * size) for size in (13, 11)]

    def picture(self, scene: Scene, instant: int) -> Image.Image:
        """Return the picture of a scene."""
        image = Image.new("RGB", self._size, colours.WATER)
        draw = ImageDraw.Draw(image)
        self._track(draw, instant)
        outline = self._pixels(placed(self._vertices, scene.reference))
        draw.line([*outline, outline[0]], fill=colours.GREY, width=LARGER)
        corners = self._pixels(placed(self._vertices, scene.pose))
        draw.polygon(corners, fill=colours.OBJECT, outline=colours.INK, width=LARGER + 1)
        self._bow(draw, scene)
        for pusher in scene.pushers:
            self._robot(draw, pusher, scene)
        for name, point in scene.travellers:
            self._dot(draw, point, name, colours.ORANGE)
        self._scale_bar(draw)
        self._header(draw, scene)
        return image.resize(
            (self._size[0] // LARGER, self._size[1] // LARGER), Image.Resampling.BOX
        )

    def _pixels(self, points: Vector) -> list[tuple[float, float]]:
        """Return points (k, 2) [m, m] of the earth's frame on the picture."""
        x, y = ((np.reshape(points, (-1, 2)) - self._low) * self._scale).T
        return list(zip(x.tolist(), (self._floor - y).tolist(), strict=True))

    def _track(self, draw: ImageDraw.ImageDraw, instant: int) -> None:
        """Draw where the object's origin has been, and the way it is to go."""
        film = self._film
        for points, colour in (
            (film.run.references[:, :2], colours.WAY),
            (film.run.poses[film.index, : instant + 1, :2], colours.BLUE),
        ):
            if len(points) > 1:
                draw.line(self._pixels(np.asarray(points, float)), fill=colour, width=LARGER)

    def _bow(self, draw: ImageDraw.ImageDraw, scene: Scene) -> None:
        """Draw a mark that tells the bow: a wedge on the axis."""
        reach = float(self._vertices[:, 0].max())
        size = 0.05 * self._extent
        wedge = np.array([(0.8 * reach, 0.0), (0.8 * reach - size, 0.5 * size),
                          (0.8 * reach - size, -0.5 * size)])  # fmt: skip
        draw.polygon(self._pixels(placed(wedge, scene.pose)), fill=colours.GREY)

    def _robot(self, draw: ImageDraw.ImageDraw, pusher: Pusher, scene: Scene) -> None:
        """Draw a robot: an arrow for its force, a dot where it holds, and its name."""
        contact = np.asarray(pusher.robot.contact) - self._film.origin
        size = float(np.hypot(*pusher.force))
        turn = pusher.robot.direction
        usual = np.nan_to_num(np.array([math.cos(turn), math.sin(turn)]))
        along = pusher.force / size if size else usual
        side = -1.0 if self._film.pushes(pusher) else 1.0
        outer = contact + side * self._longest * size * along
        ends = (outer, contact) if side < 0.0 else (contact, outer)
        tail, tip, spot = self._pixels(placed(np.array([*ends, contact]), scene.pose))
        draw.circle(spot, 2.5 * LARGER, fill=colours.BLUE)
        self._arrow(draw, tail, tip, colours.BLUE)
        aside = 0.8 * self._longest * pusher.robot.limit + 0.06 * self._extent
        x, y = self._pixels(placed((contact + side * aside * along)[None], scene.pose))[0]
        draw.text((x, y), pusher.robot.name, colours.INK, self._fonts[1], anchor="mm")

    def _arrow(
        self,
        draw: ImageDraw.ImageDraw,
        tail: tuple[float, float],
        tip: tuple[float, float],
        colour: str,
    ) -> None:
        """Draw an arrow between two places on the picture."""
        start, end = np.array(tail), np.array(tip)
        length = float(np.hypot(*(end - start)))
        head = min(length, 7.0 * LARGER)
        if length < 1.0:
            draw.circle(tip, 2 * LARGER, fill=colour)
            return
        way = (end - start) / length
        across = np.array([-way[1], way[0]])
        neck = end - head * way
        draw.line([tail, (float(neck[0]), float(neck[1]))], fill=colour, width=3 * LARGER)
        corners = [end, neck + 0.55 * head * across, neck - 0.55 * head * across]
        draw.polygon([(float(x), float(y)) for x, y in corners], fill=colour)

    def _dot(self, draw: ImageDraw.ImageDraw, point: Vector, name: str, colour: str) -> None:
        """Draw a robot on its way."""
        x, y = self._pixels(point)[0]
        draw.circle((x, y), 4 * LARGER, fill=colour)
        draw.text((x, y - 7 * LARGER), name, colours.INK, self._fonts[1], anchor="mb")

    def _scale_bar(self, draw: ImageDraw.ImageDraw) -> None:
        """Draw how long a length is."""
        unit = self._tell.length
        wanted = 0.3 * self._extent / unit.metres
        power = 10.0 ** math.floor(math.log10(wanted))
        length = max(m * power for m in (1.0, 2.0, 5.0) if m * power <= wanted)
        draw.rectangle((0, self._floor, *self._size), fill="white")
        x, y = 12.0 * LARGER, self._size[1] - 0.5 * FOOTER * LARGER
        end = x + length * unit.metres * self._scale
        draw.line([(x, y), (end, y)], fill=colours.GREY, width=LARGER)
        draw.text(
            (end + 4 * LARGER, y), f"{length:g} {unit.name}", colours.GREY, self._fonts[1], "lm"
        )

    def _header(self, draw: ImageDraw.ImageDraw, scene: Scene) -> None:
        """Write the time, what happened last, where the object is, and the wind."""
        large, small = self._fonts
        left, right = 12 * LARGER, self._size[0] - 12 * LARGER
        draw.rectangle((0, 0, self._size[0], HEADER * LARGER), fill="white")
        tell, clock = self._tell, clock_text(scene.time)
        draw.text((left, 13 * LARGER), clock, colours.INK, large, "lm")
        after = left + max(42.0 * LARGER, large.getlength(clock) + 8.0 * LARGER)
        draw.text((after, 13 * LARGER), scene.happening.told(tell), colours.INK, large, "lm")
        turned, off = abs(math.degrees(scene.turn)), scene.error / tell.length.metres
        said = f"off by {off:.{self._decimals}f} {tell.length.name}, {turned:.1f}°"
        draw.text((left, 31 * LARGER), said, colours.GREY, small, "lm")
        if scene.shortfall > 0.0:
            missing = f"out of reach by {tell.force.text(scene.shortfall)}"
            draw.text((self._size[0] // 2, 31 * LARGER), missing, colours.VERMILION, small, "mm")
        speed = float(np.hypot(*scene.wind))
        if speed > 0.0:
            text = f"wind {tell.speed(speed)}"
            draw.text((right - 24 * LARGER, 31 * LARGER), text, colours.GREY, small, "rm")
            way = 9.0 * LARGER * scene.wind / speed * np.array([1.0, -1.0])
            middle = np.array([right - 9.0 * LARGER, 31.0 * LARGER])
            self._arrow(draw, _pair(middle - way), _pair(middle + way), colours.GREY)


def clock_text(seconds: float) -> str:
    """Write a time [s] as a clock does: minutes and seconds, and hours and days if need be.

    Examples
    --------
    >>> [clock_text(time) for time in (75.4, 3600.0, 1e5)]
    ['1:15', '1:00:00', '1 d 3:46:40']
    """
    minutes, second = divmod(int(seconds), 60)
    hours, minute = divmod(minutes, 60)
    days, hour = divmod(hours, 24)
    if not hours:
        return f"{minute}:{second:02d}"
    return (f"{days} d " if days else "") + f"{hour}:{minute:02d}:{second:02d}"


def _pair(point: Iterable[float]) -> tuple[float, float]:
    """Return a place on a picture."""
    x, y = point
    return float(x), float(y)
