"""An animated picture of a run: what moves, moves in it."""

import numpy as np
import pytest
from PIL import Image, ImageDraw

from made_runs import JOINED, LOST, made_run
from swarmgrasp.plot import style
from swarmgrasp.simulation.export import colours
from swarmgrasp.simulation.export.gif import FADES, LAST, write_gif
from swarmgrasp.simulation.export.scene import Film, placed
from swarmgrasp.terms import Terms


@pytest.fixture(scope="module")
def gif(tmp_path_factory):
    return write_gif(made_run(), tmp_path_factory.mktemp("gif") / "run.gif", frames=40)


def frames_of(path):
    with Image.open(path) as found:
        for i in range(found.n_frames):
            found.seek(i)
            yield np.asarray(found.convert("RGB")), found.info["duration"]


def test_a_gif_is_small_and_rests_at_its_end(gif):
    """Forty pictures of one size in less than 150 kB; the last is shown longer."""
    frames = list(frames_of(gif))
    assert len(frames) == 40
    assert gif.stat().st_size < 150_000
    assert frames[-1][1] == LAST
    assert {frame.shape[1] for frame, _ in frames} == {480}


def test_words_are_in_the_terms_of_the_file(tmp_path, monkeypatch):
    """Off by so many feet, a wind in knots, a scale of feet, and what happened."""
    said = set()
    write = ImageDraw.ImageDraw.text
    monkeypatch.setattr(
        ImageDraw.ImageDraw, "text", lambda *a, **more: [said.add(a[2]), write(*a, **more)]
    )
    write_gif(made_run(), tmp_path / "run.gif", frames=4, terms=Terms("ft", "tf", speed="kn"))
    assert {"50 ft", "Fortuna joins.", "5:00"} <= said
    assert any(text.startswith("off by ") and " ft, " in text for text in said)
    assert any(text.startswith("wind ") and text.endswith(" kn") for text in said)
    assert any(text.startswith("out of reach by ") and text.endswith(" tf") for text in said)


def test_the_object_moves_as_the_run_says(gif):
    """The middle of what has the object's colour goes where the pose goes, to port and back."""
    run = made_run()
    film = Film(run)
    grey = np.array([int(colours.OBJECT[i : i + 2], 16) for i in (1, 3, 5)])
    middles = []
    for frame, _ in frames_of(gif):
        at = np.argwhere((frame == grey).all(axis=2))
        middles.append(at.mean(axis=0)[::-1] * (1.0, -1.0))
    chosen = list(film.picked(40))
    centroid = np.array([run.simulation.hull.centre])
    truth = np.array([placed(centroid, run.poses[0, i])[0] for i in chosen])
    moved = np.array(middles) - middles[0]
    scale = float((moved * truth).sum() / (truth * truth).sum())
    assert np.abs(moved - scale * truth).max() < 2.0
    assert np.hypot(*moved.T).max() > 15.0


def test_what_is_missing_is_told_in_its_colour(gif):
    """Vermilion is seen from the loss on until the newcomer has joined, and never else."""
    run = made_run()
    red, green, blue = (round(255 * share) for share in colours.shares(colours.VERMILION))
    times = run.times[list(Film(run).picked(40))]
    for (frame, _), time in zip(frames_of(gif), times, strict=True):
        shows = bool((frame == (red, green, blue)).all(axis=2).any())
        assert shows == (LOST < time < JOINED), time


def test_animations_have_the_colours_of_pictures():
    """Two rooms, one palette; its first fade is none."""
    for name in ("BLUE", "ORANGE", "VERMILION", "INK", "GREY"):
        assert getattr(colours, name) == getattr(style, name)
    assert FADES[0] == 1.0
