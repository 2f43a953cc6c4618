"""Quality against the number of robots."""

import math

import numpy as np
import pytest

import swarmgrasp as sg
from swarmgrasp import errors
from swarmgrasp.simulation.study import Sizes, gather, run_plan
from swarmgrasp.simulation.study.crowds import Crowds
from workers import Inline


def test_the_qualities_of_arrays_are_those_of_swarms():
    """A crowd and the swarm drawn with the same numbers; every robot is where it may be."""
    shown = sg.Outline([(-41, -10), (40, -9), (40, 10), (-38, 10)])
    zones = (sg.Zone(sg.Stretch(3.0, 70.0)), sg.Zone(sg.Stretch(100.0, 130.0), "pull", 0.2))
    asked = sg.Problem(
        sg.Swarm(shown, [], 20.0, (1.0, 2.0)), sg.Newcomer(7.0, "push", 0.5), zones
    )  # fmt: skip
    crowds = Crowds(asked)
    for count in (5, 9):
        crowd = crowds.draw(np.random.default_rng(count), (1, count))
        swarm = crowds.swarm(np.random.default_rng(count), count)
        (found,) = sg.qualities(crowds.generators(crowd))
        assert found == pytest.approx(sg.quality(swarm).value, rel=1e-9, abs=1e-9)
        for robot in swarm:
            contact = shown.at_point(robot.contact)
            pushes = contact.arc_length < 100.0
            normal = contact.inward + (0.0 if pushes else math.pi)
            off = math.remainder(robot.direction - normal, math.tau)
            assert abs(off) <= (0.5 if pushes else 0.2) + 1e-9
            assert any(z.stretch.start <= contact.arc_length <= z.stretch.end for z in zones)


def test_robots_are_spread_evenly_along_what_is_theirs(problem):
    """Over two zones by their lengths; among bollards alone, one as likely as another."""
    draws = np.random.default_rng(1)
    zones = (sg.Zone(sg.Stretch(0.0, 60.0)), sg.Zone(sg.Stretch(80.0, 100.0)))
    crowd = Crowds(sg.Problem(problem.swarm, problem.newcomer, zones)).draw(draws, (20_000,))
    assert np.mean(crowd.arms[:, 1] == -10.0) == pytest.approx(0.75, abs=0.02)
    bollards = tuple(sg.Zone(sg.Stretch(at, at)) for at in (10.0, 20.0, 90.0, 150.0))
    crowd = Crowds(sg.Problem(problem.swarm, problem.newcomer, bollards)).draw(draws, (20_000,))
    assert np.mean(crowd.arms[:, 1] == -10.0) == pytest.approx(0.5, abs=0.02)


def test_shares_with_force_closure_are_those_that_were_measured(problem, plan_of, tmp_path):
    """0.125 of four robots, 0.504 of six, 0.772 of eight; four push one way in half of all draws.

    An independent prototype measured them on such a barge.
    """
    plan = plan_of(9_000, 9_000, Sizes(problem, 4, 8))
    run_plan(tmp_path / "a", plan, executor=Inline())
    found = gather(tmp_path / "a").findings
    shares = {int(row[0]): row[2] for row in found.rows}
    runs = {int(row[0]): row[1] for row in found.rows}
    for robots, share in ((4, 0.125), (6, 0.504), (8, 0.772)):
        assert abs(shares[robots] - share) < 4.0 * math.sqrt(0.25 / runs[robots])
    assert found.headline.endswith(f"force closure from {6 if shares[6] >= 0.5 else 7} robots on")


@pytest.mark.parametrize(
    ("study", "kind", "says"),
    [
        (lambda p: Sizes(p, 5, 4), "StudyInvalid", "from 5 to 4; .* 1 <= fewest <= most <= 1000"),
        (lambda _: Sizes(3, 5, 4), "StudyInvalid", "3 is no Problem(.|\n)*from 5 to 4"),
        (lambda p: Sizes(p, "4", 5), "StudyInvalid", "from '4' to 5"),
        (lambda p: Sizes(sg.Problem(p.swarm, sg.Newcomer(1.0, "push", 0.5, steers=True))),
         "ForceSetUnsupported", "one ray"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(problem, study, kind, says):
    """By an error named after the fault."""
    with pytest.raises(getattr(errors, kind), match=says):
        study(problem)
