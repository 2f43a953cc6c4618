"""A stranger's check: honest answers pass, every tampering and every malformed file is refused."""

import ast
import contextlib
import copy
import json
import math
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import reference
from answers import (
    CREW,
    NEWCOMER,
    OUTLINE,
    QUESTION,
    SWARM,
    ZONES,
    asked,
    first,
    honest_document,
    judge,
)
from swarmgrasp import (
    Newcomer,
    Outline,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Zone,
    place,
    place_sequence,
    quality,
    read_answer,
    write_answer,
)  # fmt: skip
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import AnswerInvalid, NowhereToAttach
from swarmgrasp.verify import placement as verify
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.recompute import labels_of


@pytest.fixture
def document():
    """Return an honest document to spoil."""
    return copy.deepcopy(honest_document())


# -- honest answers -------------------------------------------------------------------


def test_a_second_newcomer_at_the_same_bollard_passes():
    """Without spacing two contacts may be one."""
    outline = Outline([(-2.1, -1.0), (1.7, -1.3), (1.9, 0.9), (-1.6, 1.1)])
    bollards = [Zone(Stretch(s, s, f"b{s}")) for s in (1.3, 4.4, 7.7)]
    for seed in range(40):
        rng = np.random.default_rng(seed)
        spots = [outline.at_arc_length(float(s)).point for s in rng.uniform(0, 10, 4)]
        swarm = Swarm(
            outline, [Robot(c, float(a)) for c, a in zip(spots, rng.uniform(-3, 3, 4), strict=True)]
        )
        answers = place_sequence(Problem(swarm, Newcomer(1.0, "pull"), tuple(bollards)), 4)
        verdict = verify_document(document_of(answers))
        assert verdict, verdict.faults


@pytest.mark.parametrize("width", [5e-10, 1.5e-9, 3e-9, 1e-7, 1.2e-6, 1.8e-6, 3e-6])
def test_the_narrowest_zones_pass(width):
    """Search and check agree on what is too narrow to attach to."""
    zone = Zone(Stretch(1.0, 1.0 + width * OUTLINE.extent, "slit"))
    try:
        answer = place(SWARM, NEWCOMER, [zone])
    except NowhereToAttach:
        assert width <= 1e-9
    else:
        verdict = answer.verify()
        assert verdict, verdict.faults


@pytest.mark.parametrize("turn", range(0, 360, 7))
def test_a_single_allowed_direction_survives_rounding(turn):
    """Exactly along the normal, given once more as an absolute direction in degrees."""
    a = math.radians(turn)
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    outline = Outline([(x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a))
                       for x, y in square])  # fmt: skip
    swarm = Swarm(outline, [Robot(outline.at_arc_length(k).point, 2.0 * k) for k in range(5)])
    for side in range(4):
        inward = math.radians(math.degrees(outline.inward_normal(side)))
        for attachment, half, only in (
            ("push", 0.0, inward), ("pull", 0.0, inward + math.pi), ("free", None, inward + 1.0),
            ("free", None, math.radians(math.degrees(inward + math.pi / 2))),
        ):  # fmt: skip
            zone = Zone(outline.stretch(side), attachment, half, directions=(only, only))
            verdict = place(swarm, Newcomer(), [zone]).verify()
            assert verdict, verdict.faults


def test_an_honest_answer_passes_also_through_a_file(document, tmp_path):
    """Numbers survive JSON to the last bit; the recomputed bound is the claimed one."""
    (claim,) = document["placements"]
    assert claim["runners_up"]
    path = tmp_path / "answer.json"
    path.write_text(json.dumps(document))
    verdict = verify_document(read_answer(path))
    assert verdict, verdict.faults
    assert verdict.upper_bounds == (pytest.approx(claim["upper_bound"], rel=1e-9),)
    write_answer(path, place_sequence(QUESTION, 3))
    assert verify_document(read_answer(path))


@pytest.mark.parametrize(
    ("zones", "no_go"),
    [
        ([(4.0, 6.0)], []),
        ([(4.0 - 1e-12, 6.0)], []),
        ([(4.0 - 1e-7, 6.0 + 1e-7)], []),
        ([(6.0, 10.0)], []),
        ([(10.0, 12.0)], []),
        ([(10.0, 0.0)], []),
        ([(12.0, 4.0)], []),
        ([(11.0, 1.0)], [(11.5, 0.5)]),
        ([(0.0, 12.0)], [(0.0, 6.1 + 0.2), (6.3, 11.0)]),
        ([(5.0, 8.0)], [(5.0, 7.0), (7.0 + 1e-12, 7.9)]),
        ([(4.0, 4.0)], []),
        ([(0.0, 0.0), (12.0, 12.0), (6.0, 6.0)], [(6.0, 7.0)]),
    ],
)
def test_honest_answers_pass_where_stretches_meet(zones, no_go):
    """At corners, at the first vertex, and where ends agree up to rounding."""
    places = [Zone(Stretch(*ends)) for ends in zones]
    for newcomer in (Newcomer(1.0, "push"), Newcomer(1.0, "pull", 0.0), Newcomer(3.0)):
        answer = place(SWARM, newcomer, places, no_go=[Stretch(*ends) for ends in no_go])
        verdict = answer.verify()
        assert verdict, verdict.faults


@pytest.mark.parametrize("seed", range(8))
def test_honest_answers_pass_on_edges_of_any_length(seed):
    """Arc lengths of corners are sums that round; a zone that is one edge is only that edge."""
    lengths = [(1.0 + 0.1 * seed, 0.3), (2.2, 1.7 / 3.0), (0.1 * seed, 2.1), (-1.0, 1.0 / 7.0)]
    outline = Outline([*lengths, (-0.3, -0.9 - 0.1 * seed)])
    crew = [
        Robot(outline.at_arc_length(0.9 * k).point, (1.3 * k + seed) % math.tau) for k in range(6)
    ]
    swarm = Swarm(outline, crew)
    for edge in range(len(outline)):
        answer = place(swarm, NEWCOMER, [Zone(outline.stretch(edge))])
        assert answer.verify().faults == ()


def test_a_number_written_another_way_is_not_an_alteration(document):
    """2.0 and 2 are the same number."""
    asked(document)["swarm"]["outline"]["origin"] = [0, 0]
    assert asked(document)["swarm"]["outline"]["origin"] == [0.0, 0.0]
    assert verify_document(document)


# -- tampering ------------------------------------------------------------------------


def _move(d):
    first(d)["robot"]["contact"][0] += 1e-3


def _leave(d):
    first(d)["robot"]["contact"][1] += 1e-4


def _turn(d):
    first(d)["robot"]["direction"] += 1e-3


def _turn_out(d):
    first(d)["robot"]["direction"] += math.pi


def _better(d):
    first(d)["quality"] *= 1.0 + 1e-7


def _bound(d):
    first(d)["upper_bound"] = 0.5 * (first(d)["quality"] + first(d)["upper_bound"])


def _no_proofs(d):
    first(d)["proofs"] = []


def _bent(d):
    for proof in first(d)["proofs"]:
        proof["normals"][0][0] += 1e-2


def _zone(d):
    asked(d)["zones"][0]["stretch"]["end"] += 0.5


def _zone_away(d):
    asked(d)["zones"][0]["stretch"].update(start=0.0, end=3.0)
    asked(d)["zones"].pop()


def _everywhere(d):
    asked(d)["zones"] = None


def _wider(d):
    asked(d)["newcomer"]["half_angle"] = 1.5


def _stronger(d):
    asked(d)["newcomer"]["limit"] = first(d)["robot"]["limit"] = 1.1


def _limit(d):
    asked(d)["newcomer"]["limit"] = 1.1


def _spacing(d):
    asked(d)["spacing"] = 4.0


def _runner(d):
    first(d)["runners_up"][0]["quality"] *= 1.01


def _before(d):
    first(d)["quality_before"] += 1e-6


def _crew(d):
    for robot in asked(d)["swarm"]["robots"]:
        robot["limit"] *= 1.001


def _object(d):
    asked(d)["swarm"]["outline"]["vertices"][2][0] += 0.5


def _origin(d):
    asked(d)["swarm"]["outline"]["origin"][0] += 1e-3


def _metric(d):
    asked(d)["swarm"]["characteristic_length"] *= 1.001


def _weights(d):
    asked(d)["swarm"]["force_weights"][1] = 1.01


def _mounted(d):
    first(d)["robot"]["mounted"] = True


def _name(d):
    asked(d)["swarm"]["robots"][0]["name"] = "Zoe"


TAMPERINGS = [
    (_move, "the quality with the robot is said to be"),
    (_leave, "is not an allowed one"),
    (_turn, "the quality with the robot is said to be"),
    (_turn_out, "is not an allowed one"),
    (_better, "the quality with the robot is said to be"),
    (_bound, "the proofs show an upper bound"),
    (_no_proofs, "the proofs show an upper bound of inf"),
    (_bent, "the proofs show an upper bound"),
    (_zone, "the proofs show an upper bound"),
    (_zone_away, "is not an allowed one"),
    (_everywhere, "the proofs show an upper bound"),
    (_wider, "the proofs show an upper bound"),
    (_stronger, "the quality with the robot is said to be"),
    (_limit, "not the newcomer's"),
    (_spacing, "is not an allowed one"),
    (_runner, "the quality with the runner-up at"),
    (_before, "the quality before is said to be"),
    (_crew, "the quality before is said to be"),
    (_object, ""),
    (_origin, "the quality before is said to be"),
    (_metric, "the quality before is said to be"),
    (_weights, "the quality before is said to be"),
    (_mounted, "is mounted, and the newcomer otherwise"),
]


@pytest.mark.parametrize(("spoil", "says"), TAMPERINGS, ids=lambda v: getattr(v, "__name__", ""))
def test_tampering_is_refused_by_digest_and_by_mathematics(document, spoil, says):
    """Once as found, once with a digest that fits again."""
    spoil(document)
    verdict = verify_document(document)
    assert "the digest does not fit" in verdict.faults[0]
    again = judge(document)
    assert any(says in fault for fault in again.faults), again.faults


def _hopeless(d):
    claim = first(d)
    spot = OUTLINE.at_arc_length(6.4)
    claim["robot"].update(contact=list(spot.point), direction=spot.inward + 0.4)
    more = SWARM.with_robot(Robot(spot.point, spot.inward + 0.4))
    claim["quality"] = quality(more).value
    claim.update(improves=False, reason="nothing helps", runners_up=[])


def _overboard(d):
    asked(d)["swarm"]["robots"][0].update(contact=[-1.5, -51.0], mounted=True)


def _twice(d):
    first(d)["runners_up"] *= 2


def _elsewhere(d):
    first(d)["place"] = "bollard" if first(d)["place"] == "quay" else "quay"


def _tiny_normals(d):
    for proof in first(d)["proofs"]:
        proof["normals"] = [[2e-162 * c for c in normal] for normal in proof["normals"]]
    first(d)["upper_bound"] *= 0.9


def _many_turns(d):
    first(d)["robot"]["direction"] = 1e16


@pytest.mark.parametrize("spoil", [_hopeless, _overboard, _twice, _elsewhere, _tiny_normals,
                                   _many_turns])  # fmt: skip
def test_a_forgery_is_refused_by_more_than_its_digest(document, spoil):
    """False despair, a robot that floats, a repeated runner-up, numbers made to round."""
    spoil(document)
    try:
        verdict = judge(document)
    except AnswerInvalid:
        return
    assert not verdict
    assert not any("digest" in fault for fault in verdict.faults)


@pytest.mark.parametrize(
    ("giant", "claimed"),
    [
        ({"contact": [0.0, 0.0], "mounted": True, "limit": 1e16}, 123.0),
        ({"limit": 1e14}, 5.0),
        ({"limit": 1e9}, 1e-3),
    ],
)
def test_no_giant_lends_a_claim_its_rounding(document, giant, claimed):
    """Beside a robot that is much stronger a claim is refused, or said not to be checked."""
    robots = asked(document)["swarm"]["robots"]
    robots.append({**robots[0], "name": "Goliath", **giant})
    claim = first(document)
    claim.update(runners_up=[], improves=False)
    claim.update(quality_before=claimed, quality=claimed, upper_bound=claimed)
    verdict = judge(document)
    assert not verdict
    claim.update(quality_before=1e-3, quality=1e-3, upper_bound=1e-3)
    if verdict := judge(document):
        assert "by the rounding of robots that are so much stronger" in verdict.unchecked[0]


def test_a_true_answer_beside_a_giant_says_how_far_it_is_checked():
    """Its rounding is far above a millionth of the quality."""
    mighty = Robot(OUTLINE.at_arc_length(0.2).point, 1.0, limit=1e10)
    verdict = place(SWARM.with_robot(mighty), NEWCOMER).verify()
    assert verdict, verdict.faults
    assert "by the rounding of robots that are so much stronger" in verdict.unchecked[0]
    assert not place(SWARM, NEWCOMER).verify().unchecked


def test_numbers_whose_squares_overflow_are_refused(document):
    """Nothing near them can be checked, so that anything would pass."""
    asked(document)["swarm"]["characteristic_length"] = 1e-100
    asked(document)["criterion"]["load"] = [1e100, 0.0, 1e100]
    with pytest.raises(AnswerInvalid, match="too large to be squared"):
        judge(document)


def test_a_changed_name_is_refused_by_the_digest(document):
    """Mathematics does not know names."""
    _name(document)
    assert not verify_document(document)
    assert judge(document)


class Looked(str):
    """A name that counts how often names are compared."""

    times = 0

    def __eq__(self, other):
        Looked.times += 1
        return str.__eq__(self, other)

    __hash__ = str.__hash__


def test_names_of_zones_are_looked_at_once():
    """Of a thousand zones of one name each is numbered without a look at all the others."""
    zones = [SimpleNamespace(name=Looked("quay")) for _ in range(1000)]
    labels = labels_of([zones[0], None, *zones[1:], ZONES[1]])
    assert labels[:3] == ["quay (1)", "", "quay (2)"]
    assert labels[-2:] == ["quay (1000)", "bollard"]
    assert Looked.times < 10_000


def test_the_other_placements_of_a_sequence_count():
    """A later robot finds the earlier ones; leaving one out is noticed."""
    document = document_of(place_sequence(QUESTION, 3))
    assert judge(document)
    del document["placements"][1]
    faults = judge(document).faults
    assert faults
    assert all(fault.startswith("placement 2: ") for fault in faults)


def test_no_gain_is_no_improvement():
    """A robot that adds nothing may not be said to improve the swarm."""
    document = document_of(place(Swarm(OUTLINE, CREW[:2]), NEWCOMER))
    assert judge(document)
    first(document)["improves"] = True
    assert "the newcomer is said to improve" in judge(document).faults[0]


def _worse(document):
    """Replace the robot by a worse one with its true quality, said to be the best."""
    claim = first(document)
    asked(document).update(zones=None, no_go=[], spacing=0.0)
    claim["runners_up"] = []
    claim["robot"].update(contact=[0.0, -1.0], direction=math.pi / 2)
    rows = [*asked(document)["swarm"]["robots"], claim["robot"]]
    B = reference.generators(
        [r["contact"] for r in rows], [r["direction"] for r in rows], [r["limit"] for r in rows],
        asked(document)["swarm"]["outline"]["origin"], SWARM.scale,
    )  # fmt: skip
    claim["quality"] = claim["upper_bound"] = reference.quality(B)
    claim["improves"] = claim["quality"] > claim["quality_before"] + 1e-9


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # the verdict counts, with or without
@pytest.mark.parametrize(
    "proof",
    [
        {"normals": [[1e200, 0.0, 0.0]], "weights": [1.0]},  # its length overflows
        {"normals": [[1e-200, 0.0, 0.0]], "weights": [1.0]},
        {"normals": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], "weights": [1e308, 1e308]},
        {"normals": [[0.0, 0.0, 0.0]], "weights": [1.0]},
        {"normals": [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]], "weights": [2.0, -1.0]},
        {"normals": [[0.0, 0.0, 1.0]], "weights": [1.0, 1.0]},
        {"normals": [[0.0, 0.0, 1.0]], "weights": [0.0]},
    ],
)
def test_a_forged_proof_proves_nothing(document, proof):
    """Overflow, zero, negative weights: none shows a bound that does not hold."""
    _worse(document)
    first(document)["proofs"] = [proof]
    try:
        verdict = judge(document)
    except AnswerInvalid:
        return
    assert any("the proofs show" in fault for fault in verdict.faults), verdict


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_no_cell_of_length_zero_hides_the_others(document):
    """A repeated vertex with a bollard on it does not make the bound undefined."""
    _worse(document)
    for robot in asked(document)["swarm"]["robots"]:
        robot["mounted"] = True
    asked(document)["swarm"]["outline"]["vertices"].insert(1, [2.0, -1.0])
    asked(document)["swarm"]["outline"]["edge_names"].append("")
    bollards = Zone(Stretch(4.0, 4.0)), Zone(Stretch(0.0, 4.0))
    asked(document)["zones"] = [bollard.to_data() for bollard in bollards]
    with contextlib.suppress(AnswerInvalid):
        assert not judge(document)


# -- independence ---------------------------------------------------------------------


def test_the_check_shares_no_code_with_the_search():
    """Of the package it imports its own modules and the errors, and no solver."""
    for file in Path(verify.__file__).parent.glob("*.py"):
        names = set()
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                names |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                assert node.level == 0
                names.add(node.module)
        ours = {name for name in names if name.startswith("swarmgrasp")} - {"swarmgrasp.errors"}
        assert all(name.startswith("swarmgrasp.verify") for name in ours), file
        assert not names & {"importlib", "highspy"}, file
        assert file.name == "claims.py" or "shapely" not in names, file
