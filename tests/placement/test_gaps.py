"""Newcomers beside robots with gaps between their sectors: a place and a bound (T28)."""

import numpy as np
import pytest

from crews import SIDES
from swarmgrasp import (
    Newcomer,
    Outline,
    Problem,
    Robot,
    Swarm,
    Tolerance,
    place,
    place_sequence,
    quality,
    verify_document,
)  # fmt: skip
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import RobotInvalid
from swarmgrasp.verify.digest import digest_of

BARGE = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
NAMES = {"bow": 30.0, "fore": 10.0, "aft": -10.0, "stern": -30.0}
ROW = Swarm(
    BARGE,
    [Robot((x, 0.0), limit=90.0, name=n, mounted=True, sectors=SIDES) for n, x in NAMES.items()],
)
PUSHING = Newcomer(60.0, "push", half_angle=0.5)


@pytest.mark.parametrize("terms", [{}, {"losing": 1}, {"load": (0.0, 20.0, 0.0)}])
@pytest.mark.parametrize(
    "newcomer", [PUSHING, Newcomer(60.0, "push", half_angle=0.5, steers=True),
                 Newcomer(60.0, reverse_limit=60.0)]
)  # fmt: skip
def test_the_answer_holds_and_no_place_exceeds_the_bound(newcomer, terms):
    """The quality is that of a choice of sectors with the robot; the bound, of gaps filled."""
    answer = place(ROW, newcomer, gap=1e-4, **terms)
    after = quality(answer.swarm_after, **terms)
    before = quality(ROW, **terms)
    assert answer.quality_before == pytest.approx(before.value, rel=1e-6)
    assert before.value * (1 - 1e-6) <= answer.quality <= after.value * (1 + 1e-5)
    filled = place(ROW.filled, newcomer, gap=1e-4, **terms)
    assert answer.upper_bound == pytest.approx(filled.upper_bound, rel=1e-9)
    assert after.upper_bound <= answer.upper_bound * (1 + 1e-9)
    verdict = answer.verify()
    assert verdict, verdict.faults


def test_robots_tried_stay_below_the_bound():
    """A push at random, anywhere: with any sectors chosen it has no more than was proven."""
    answer, rng = place(ROW, PUSHING), np.random.default_rng(3)
    for _ in range(30):
        spot = BARGE.at_arc_length(float(rng.uniform(0.0, BARGE.perimeter)))
        robot = Robot(spot.point, spot.inward + float(rng.uniform(-0.5, 0.5)), 60.0)
        assert quality(ROW.with_robot(robot)).upper_bound <= answer.upper_bound * (1 + 1e-6)


def test_words_and_sequences():
    """Sectors kept are named; the next newcomer finds the first, and all of it is checked."""
    answers = place_sequence(Problem(ROW, PUSHING), 2)
    assert answers[1].quality_before >= answers[0].quality * (1 - 1e-5)
    said = answers[0].explanation.splitlines()
    assert said[0].startswith("As long as robots keep to sectors, bow in 20 to 160 deg, fore in")
    assert "that is proven with the gaps filled" in said[-1]
    assert answers[0].reason.startswith("with the sectors kept, ")
    assert verify_document(document_of(answers))


def test_a_forged_answer_is_refused():
    """Sectors that are none, a quality and a bound that the proofs do not show."""
    document = document_of(place(ROW, PUSHING))
    assert verify_document(document)

    def fault(**changes):
        """Return what is wrong with the document once it says something else."""
        forged = {**document, "placements": [{**document["placements"][0], **changes}]}
        del forged["digest"]
        return "; ".join(verify_document({**forged, "digest": digest_of(forged)}).faults)

    (claim,) = document["placements"]
    sectors = claim["choice"]["sectors"]
    assert "sectors said to be kept" in fault(choice=None)
    for wrong in ([0.0, 1.0], [0.4, 6.0]):
        forged = {"sectors": {**sectors, "bow": wrong}, "is_best": True}
        assert "sectors said to be kept" in fault(choice=forged)
    turned = next(s for s in map(list, SIDES) if abs(s[0] - sectors["bow"][0]) > 1e-9)
    other = {"sectors": {**sectors, "bow": turned}, "is_best": True}
    assert "the quality with the robot" in fault(choice=other)
    assert "the quality with the robot" in fault(quality=1.5 * claim["quality"])
    assert "the quality before" in fault(quality_before=1.01 * claim["quality_before"])
    assert "upper bound" in fault(upper_bound=0.9 * claim["upper_bound"])


def test_a_tolerance_of_sectors_is_refused():
    """In the worst case only; otherwise nobody looks at it."""
    loose = Robot(
        (0.0, 5.0), limit=50.0, mounted=True, sectors=SIDES, tolerance=Tolerance(direction=0.1)
    )
    with pytest.raises(RobotInvalid, match="sectors with gaps between"):
        place(ROW.with_robot(loose), PUSHING, worst_case=True)
    assert place(ROW.with_robot(loose), PUSHING).improves
