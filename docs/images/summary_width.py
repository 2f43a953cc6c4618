"""How sharp a summary is, against its size: writes summary-width.png beside this file."""

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from swarmgrasp import Outline, Swarm
from swarmgrasp.plot import save, style
from swarmgrasp.summary import Summary

ROBOTS = 100_000
BINS = [12 * k * k for k in (1, 2, 3, 4, 6, 8, 11, 16, 22)]
TURNS = 2.0 * np.pi * np.arange(12) / 12
RECTANGLE = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
TWELVE = Outline(np.column_stack([np.cos(TURNS), np.sin(TURNS)]))
LOOKS = ((style.BLUE, "o"), (style.GREEN, "s"), (style.VERMILION, "D"), (style.PURPLE, "^"))


def swarm_on(outline, arcs, turn):
    """Return unit robots at arc lengths (n,) [m], turned (n,) [rad] from the inward normals."""
    edges = np.searchsorted(outline.corner_arc_lengths, arcs, side="right") - 1
    start, end = outline.vertices, np.roll(outline.vertices, -1, axis=0)
    along = (end - start) / outline.lengths[:, None]
    contacts = start[edges] + along[edges] * (arcs - outline.corner_arc_lengths[edges])[:, None]
    inward = np.arctan2(along[:, 0], -along[:, 1])
    return Swarm.from_arrays(outline, contacts, inward[edges] + turn)


def swarms():
    """Return the swarms to summarise, by name."""
    rng = np.random.default_rng(1)
    on_both = [rng.uniform(0.0, o.perimeter * (1.0 - 1e-9), ROBOTS) for o in (RECTANGLE, TWELVE)]
    group, spots = rng.integers(12, size=ROBOTS), rng.uniform(0.1, 0.9, 12)
    near = (spots[group] * RECTANGLE.perimeter + 0.05 * rng.normal(size=ROBOTS)) % 11.999
    half = 0.5 * np.pi
    return {
        "rectangle, any direction": swarm_on(
            RECTANGLE, on_both[0], rng.uniform(-np.pi, np.pi, ROBOTS)
        ),
        "12-gon, pushing within 30°": swarm_on(
            TWELVE, on_both[1], rng.uniform(-half / 3.0, half / 3.0, ROBOTS)
        ),
        "12-gon, along normals": swarm_on(TWELVE, on_both[1], np.zeros(ROBOTS)),
        "rectangle, twelve clusters": swarm_on(
            RECTANGLE, near, rng.uniform(-half, half, 12)[group] + 0.05 * rng.normal(size=ROBOTS)
        ),
    }


def draw(path):
    """Draw the relative width of the quality's bounds over the bytes of a message."""
    with style.settings():
        figure = Figure(figsize=(style.WIDTH, 3.3), layout="constrained")
        ax = figure.add_subplot()
        ax.grid(visible=True)
        for (name, swarm), (colour, marker) in zip(swarms().items(), LOOKS, strict=True):
            sizes, widths = [], []
            for bins in BINS:
                message = Summary.of(swarm, bins).to_bytes()
                bounds = Summary.from_bytes(message).quality()
                sizes.append(len(message))
                widths.append(bounds.width / bounds.upper)
            ax.plot(sizes, widths, color=colour, marker=marker, ms=3.5, lw=1.1, label=name)
        ends = np.array([1e3, 3e4])
        ax.plot(ends, 0.2 * ends[0] / ends, color=style.GREY, ls=":", lw=1.0, label="1 / bytes")
        ax.set(xscale="log", yscale="log")
        ax.set(xlabel="bytes of the message", ylabel="width of the bounds, relative")
        ax.xaxis.set_major_formatter(lambda b, _: f"{b / 1000.0:g} kB" if b >= 1e3 else f"{b:g} B")
        ax.yaxis.set_major_formatter(lambda share, _: f"{100.0 * share:g} %")
        figure.legend(loc="outside lower center", ncols=3)
        save(figure, path)


if __name__ == "__main__":
    draw(Path(__file__).with_name("summary-width.png"))
