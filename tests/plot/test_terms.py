"""Pictures are told in the units, the frame and the words of their file."""

import math

import numpy as np
import pytest
from matplotlib.text import Text

from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.capability import capability, thrust_use
from swarmgrasp.environment import BLENDERMANN, Environment, Wind
from swarmgrasp.forces import forces
from swarmgrasp.plot import (
    capability_diagram,
    forces_plan,
    landscape,
    plan,
    sensitivity_plan,
    thrust_use_picture,
    wrench_sets,
)
from swarmgrasp.quality import quality, sensitivities
from swarmgrasp.terms import Frame, Terms

FEET = 0.3048
SURVEY = Terms("ft", "tf", speed="km/h", robot="tug", frame=Frame(bow=math.pi / 2))
MARINE = Terms("ft", "tf", robot="tug", frame=Frame(mirrored=True, heading=math.radians(30.0)))


def texts(figure):
    figure.draw_without_rendering()
    return [text.get_text() for text in figure.findobj(Text) if text.get_text()]


def ticks(axis):
    """Return where ticks are, and the numbers written there."""
    axis.axes.figure.draw_without_rendering()
    words = [label.get_text().replace("\N{MINUS SIGN}", "-") for label in axis.get_ticklabels()]
    return np.asarray(axis.get_ticklocs()), np.array([float(word) for word in words])


@pytest.mark.parametrize(
    ("terms", "across", "up"),
    [
        (MARINE, ("x [ft]", 1.0), ("y [ft]", -1.0)),
        (SURVEY, ("y [ft]", 1.0), ("x [ft]", -1.0)),
        (Terms(), ("x [m]", 1.0 / FEET), ("y [m]", 1.0 / FEET)),
        (
            Terms("ft", frame=Frame(bow=0.5)),
            ("ahead of (0, 0) [ft]", 1.0),
            ("to port of (0, 0) [ft]", 1.0),
        ),
    ],
)
def test_a_plan_is_ticked_in_the_coordinates_of_the_file(barge, terms, across, up):
    """Round numbers of its unit, which grow the way its axes point."""
    ax = plan(barge, terms=terms).axes[0]
    for axis, (name, sense) in ((ax.xaxis, across), (ax.yaxis, up)):
        drawn, told = ticks(axis)
        assert axis.get_label_text() == name
        np.testing.assert_allclose(drawn, told * sense * FEET, atol=1e-9)
        assert (told == told.round()).all()


def test_every_picture_tells_forces_and_lengths_in_the_units_of_the_file(barge, placement):
    """No newton, no metre and no robot is left, whichever picture it is."""
    load = (0.0, -60e3, 1e6)
    found = quality(barge, load=load)
    pictures = [
        plan(barge, quality=found, placements=[placement], terms=SURVEY),
        forces_plan(forces(barge, (0.0, 0.0, 0.0), load=load), terms=SURVEY),
        landscape(placement, resolution=(20, 10), terms=SURVEY),
        sensitivity_plan(sensitivities(barge, load=load), terms=SURVEY),
        wrench_sets(barge, criterion=found.criterion, terms=SURVEY),
    ]
    for figure in pictures:
        said = " ".join(texts(figure))
        assert " tf" in said or "[tf]" in said
        for foreign in ("kN", " m.", "[m]", "robot"):
            assert foreign not in said, (foreign, said)
    assert "6.12 tf to starboard, 335 tf ft turning to port" in " ".join(texts(pictures[1]))


def test_a_landscape_grows_as_the_file_counts(placement):
    """Of a file with y to starboard clockwise along the boundary, and clockwise round."""
    ax = landscape(placement, resolution=(20, 10), terms=MARINE).axes[0]
    around = placement.problem.swarm.outline.perimeter
    drawn, told = ticks(ax.xaxis)
    np.testing.assert_allclose(told, (around - drawn) / FEET, atol=0.6)
    assert ax.xaxis_inverted()
    drawn, told = ticks(ax.yaxis)
    assert told[1:-1].tolist() == (-drawn[1:-1]).tolist()
    assert ax.yaxis_inverted()
    ax = landscape(placement, resolution=(20, 10), terms=Terms(bearings=True)).axes[0]
    assert ticks(ax.yaxis)[1].tolist() == [180.0, 90.0, 0.0, 270.0, 180.0]
    assert ax.get_ylabel() == "bearing of the force [°]"


def test_polar_diagrams_tell_true_bearings_where_there_is_a_heading():
    """The bow up, north where the heading has it, and the least wind by its true bearing."""
    hull = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    ways = ((0, 10, -90), (0, -10, 90), (40, 0, 180), (-40, 0, 0), (30, 10, -90), (-30, -10, 90))
    swarm = Swarm(hull, [Robot((x, y), math.radians(turn), 2e5) for x, y, turn in ways])
    weather = Environment(Wind(150.0, 500.0, BLENDERMANN["tender"]))
    found = capability(swarm, weather, np.radians(np.arange(0, 360, 30)))
    figure = capability_diagram(found, terms=MARINE)
    figure.draw_without_rendering()
    marks = {
        text.get_text(): text.get_window_extent().get_points().mean(axis=0)
        for text in figure.findobj(lambda artist: artist.get_gid() == "bearing")
    }
    middle = figure.axes[0].transData.transform((0.0, 0.0))
    east, north = marks["90° E"] - middle, marks["0° N"] - middle
    assert math.degrees(math.atan2(*north)) == pytest.approx(-30.0, abs=1.0)
    assert math.degrees(math.atan2(*east)) == pytest.approx(60.0, abs=1.0)
    said = texts(figure)
    least = math.degrees(found.bearings[found.worst]) + 30.0
    assert f"{least % 360.0:.4g}°" in said
    assert any("true; bow up, at 30°" in text for text in said)
    use = texts(thrust_use_picture(thrust_use(swarm, weather, 10.0, found.bearings), terms=MARINE))
    assert "where it comes from, true; the bow is at 30°" in use
    assert {"0° N", "90° E", "180° S", "270° W"} < set(use)
