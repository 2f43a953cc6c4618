"""Push forces of robots with gaps between their sectors: decided over all choices (T28)."""

import math
from dataclasses import replace

import numpy as np
import pytest

import reference
from crews import SIDES, robots_with_gaps, unit
from swarmgrasp import Robot, forces, forces_along
from swarmgrasp.forces.certificate import SectorsProof
from swarmgrasp.swarm.choices import Choices


def aside(robot, force):
    """Return how far a force lies beside the nearest of a robot's sectors [N]."""
    way = math.atan2(force[1], force[0])
    offs = [
        abs(math.remainder(way - 0.5 * (a + b), math.tau)) - 0.5 * (b - a)
        for a, b in robot.sectors or [(way, way)]
    ]
    return math.hypot(*force) * math.sin(min(max(min(offs), 0.0), math.pi / 2))


@pytest.mark.parametrize("seed", range(12))
def test_the_least_share_is_that_of_all_choices(seed):
    """A linear program for each choice of sectors finds the same, within its fans."""
    rng = np.random.default_rng([seed, 1])
    swarm = unit(*robots_with_gaps(rng, 3, 2))
    wrench = rng.normal(size=3) * [0.5, 0.5, 0.3]
    found = forces(swarm, wrench)
    arms = swarm.contacts - swarm.outline.origin
    least = reference.least_factor_of_sectors(swarm.robots, arms, swarm.scale, wrench)
    assert (found.shortfall > 0.0) == (least > 1.00002)
    if not found.shortfall:
        assert found.needed == pytest.approx(least, rel=3e-5)
    assert found.verify(), found.verify().faults


@pytest.mark.parametrize("seed", range(12))
def test_no_choice_serves_better(seed):
    """Nor comes nearer to a wrench out of reach, nor does as well with less squares."""
    rng = np.random.default_rng([seed, 2])
    both = Robot((0.0, 0.2), 0.3, 1.0, reverse_limit=1.0, mounted=True)
    swarm = unit(*robots_with_gaps(rng, 2, 2), both)
    wrenches = rng.normal(size=(4, 3)) * np.array([0.1, 0.5, 1.0, 3.0])[:, None]
    choices = Choices(swarm)
    fixed = [choices.swarm(taken) for taken in np.ndindex(*map(len, choices.options))]
    for found in forces_along(swarm, wrenches, load=(0.1, 0.0, 0.0)):
        each = [forces(one, found.wanted, load=found.load) for one in fixed]
        costs = [(f.shortfall, f.largest_share, ((f.forces / swarm.limits) ** 2).sum())
                 for f in [found, *each]]  # fmt: skip
        np.testing.assert_allclose(costs[0], min(costs[1:]), rtol=3e-5, atol=1e-9)
        assert max(map(aside, swarm.robots, found.vectors)) <= 1e-9
        assert found.verify(), found.verify().faults


def test_a_push_ahead_takes_two_thrusters():
    """Neither may push ahead: they push ahead aside, one to port and the other to starboard."""
    pair = unit(*(Robot((0.0, y), sectors=SIDES, mounted=True) for y in (0.1, -0.1)))
    found = forces(pair, (1.0, 0.0, 0.0))
    assert found.shortfall == 0.0
    assert found.needed >= 0.5 / math.cos(math.radians(20)) * (1.0 - 1e-9)
    np.testing.assert_allclose(np.sin(found.directions).sum(), 0.0, atol=1e-6)
    alone = forces(unit(pair["R1"]), (1.0, 0.0, -0.1))
    assert alone.is_degraded
    assert alone.verify()


def test_a_ray_each_way_is_a_reversible_thruster():
    """Two sectors of no width and opposite are a segment; forces and shares are the same."""
    rays = [
        Robot((x, 0.3), sectors=[(0.4, 0.4), (0.4 + math.pi,) * 2], mounted=True) for x in (0, 1)
    ]
    lines = [Robot(r.contact, 0.4, reverse_limit=1.0, mounted=True) for r in rays]
    for wrench in ((0.3, 0.1, 0.0), (-0.4, -0.2, 0.1)):
        one, other = forces(unit(*rays), wrench), forces(unit(*lines), wrench)
        np.testing.assert_allclose(one.vectors, other.vectors, atol=1e-6)
        assert one.verify()


def test_a_false_claim_is_refused():
    """Forces in a gap, proofs of too few choices, and normals that prove nothing."""
    swarm = unit(*(Robot((0.6 * x, 0.0), sectors=SIDES, mounted=True) for x in (1, -1)))
    found = forces(swarm, (0.9, 0.1, 0.02))
    assert found.verify()
    proof = found.certificate.sectors
    assert proof.others

    def fault(**changes):
        """Return what is wrong with the same once its proof is another."""
        forged = replace(proof, **changes)
        certificate = replace(found.certificate, sectors=forged)
        return "; ".join(replace(found, certificate=certificate).verify().faults)

    assert "are not all choices" in fault(others=proof.others[1:])
    flat = tuple((kept, -normal) for kept, normal in proof.others)
    assert "does not prove that other sectors" in fault(others=flat)
    assert "no part of a robot" in fault(kept=((0, (0.0, 1.0)),))
    assert "keep one sector each" in fault(kept=((5, SIDES[0]),))
    ahead = replace(found, vectors=np.array([(0.9, 0.0), (0.0, 0.1)]))
    assert "lies in a gap" in "; ".join(ahead.verify().faults)
    trusting = replace(proof, others=(), is_best=False)
    certificate = replace(found.certificate, sectors=trusting)
    verdict = replace(found, certificate=certificate).verify()
    assert verdict.unchecked
    assert isinstance(trusting, SectorsProof)


def test_no_wrenches():
    """An empty trajectory has no forces."""
    assert (
        len(forces_along(unit(*robots_with_gaps(np.random.default_rng(0), 1, 2)), np.zeros((0, 3))))
        == 0
    )
