import os

import matplotlib as mpl
import pytest
from matplotlib.figure import Figure

from swarmgrasp import Robot, SwarmGraspError
from swarmgrasp.plot import landscape, plan, save, wrench_sets
from swarmgrasp.quality import quality

SUFFIXES = ["pdf", "png", "svg"]


@pytest.fixture(scope="module")
def picture(barge):
    return plan(barge)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_the_same_picture_is_the_same_file(barge, tmp_path, suffix):
    one = save(plan(barge), tmp_path / f"one.{suffix}")
    other = save(plan(barge), tmp_path / f"other.{suffix}")
    assert one.read_bytes() == other.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"one.{suffix}", f"other.{suffix}"]


def test_pictures_of_fifteen_robots_are_light(crowd, tmp_path):
    after = crowd.with_robot(Robot((1.8, 0.1), 0.0))
    pictures = {"plan": plan(crowd, quality=quality(crowd)), "sets": wrench_sets(crowd, after)}
    for name, figure in pictures.items():
        sizes = {s: save(figure, tmp_path / f"{name}.{s}").stat().st_size for s in SUFFIXES}
        assert sizes["svg"] < 200_000
        assert sizes["pdf"] < 200_000
        assert sizes["png"] < 400_000


def test_the_landscape_is_light(placement, tmp_path):
    path = save(landscape(placement), tmp_path / "landscape.svg")
    assert path.stat().st_size < 200_000


@pytest.mark.parametrize("name", ["picture.jpeg", "picture", "picture.svg.gz"])
def test_an_unknown_suffix_is_refused_with_those_that_are_known(picture, tmp_path, name):
    with pytest.raises(SwarmGraspError, match=r"\.pdf, \.png, \.svg"):
        save(picture, tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_the_suffix_may_be_in_capitals(picture, tmp_path):
    assert save(picture, str(tmp_path / "A.PNG")).read_bytes().startswith(b"\x89PNG")


def test_a_missing_folder_is_named(picture, tmp_path):
    with pytest.raises(SwarmGraspError, match=r"no folder .*nowhere"):
        save(picture, tmp_path / "nowhere" / "a.png")


def test_a_folder_is_not_overwritten(picture, tmp_path):
    (tmp_path / "a.png").mkdir()
    with pytest.raises(SwarmGraspError, match="is a folder; give a file in it"):
        save(picture, tmp_path / "a.png")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_closed_folder_is_an_error_of_ours(picture, tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(SwarmGraspError, match="may not be written to"):
        save(picture, tmp_path / "a.png")


def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path):
    class Broken(Figure):
        def savefig(self, path, **options):
            super().savefig(path, **options)
            raise OSError(28, "No space left on device")

    path = tmp_path / "a.svg"
    path.write_text("old")
    with pytest.raises(SwarmGraspError, match="No space left"):
        save(Broken(), path)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_drawing_leaves_the_settings_of_others_alone(barge, placement, tmp_path):
    before = dict(mpl.rcParams)
    save(plan(barge, placements=[placement]), tmp_path / "a.svg")
    wrench_sets(barge)
    landscape(placement, resolution=(20, 10))
    assert dict(mpl.rcParams) == before
