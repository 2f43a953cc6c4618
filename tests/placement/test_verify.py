"""A stranger's check: honest answers pass, every tampering and every malformed file is refused."""

import ast
import contextlib
import copy
import json
import math
from pathlib import Path

import pytest

import reference
from answers import CREW, NEWCOMER, OUTLINE, QUESTION, SWARM, first, honest_document, judge
from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Zone, place, place_sequence
from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.placement import read_answer, verify, verify_document, write_answer
from swarmgrasp.placement.document import document_of


@pytest.fixture
def document():
    """Return an honest document to spoil."""
    return copy.deepcopy(honest_document())


# -- honest answers -------------------------------------------------------------------


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
    crew = [Robot(outline.at_arc_length(0.9 * k).point, 1.3 * k + seed) for k in range(6)]
    swarm = Swarm(outline, crew)
    for edge in range(len(outline)):
        answer = place(swarm, NEWCOMER, [Zone(outline.stretch(edge))])
        assert answer.verify().faults == ()


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
    first(d)["zones"][0]["end"] += 0.5


def _zone_away(d):
    first(d)["zones"][0].update(start=0.0, end=3.0)
    first(d)["zones"].pop()


def _everywhere(d):
    first(d)["zones"] = None


def _wider(d):
    first(d)["newcomer"]["half_angle"] = 1.5


def _stronger(d):
    first(d)["newcomer"]["limit"] = first(d)["robot"]["limit"] = 1.1


def _limit(d):
    first(d)["newcomer"]["limit"] = 1.1


def _spacing(d):
    first(d)["spacing"] = 4.0


def _runner(d):
    first(d)["runners_up"][0]["quality"] *= 1.01


def _before(d):
    first(d)["quality_before"] += 1e-6


def _crew(d):
    for robot in d["robots"]:
        robot["limit"] *= 1.001


def _object(d):
    d["outline"]["vertices"][2][0] += 0.5


def _origin(d):
    d["outline"]["origin"][0] += 1e-3


def _metric(d):
    d["metric"]["characteristic_length"] *= 1.001


def _weights(d):
    d["metric"]["force_weights"][1] = 1.01


def _mounted(d):
    first(d)["robot"]["mounted"] = True


def _name(d):
    d["robots"][0]["name"] = "Zoe"


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
    (_mounted, "a newcomer is on the boundary"),
]


@pytest.mark.parametrize(("spoil", "says"), TAMPERINGS, ids=lambda v: getattr(v, "__name__", ""))
def test_tampering_is_refused_by_digest_and_by_mathematics(document, spoil, says):
    """Once as found, once with a digest that fits again."""
    spoil(document)
    verdict = verify_document(document)
    assert "the digest does not fit" in verdict.faults[0]
    again = judge(document)
    assert any(says in fault for fault in again.faults), again.faults


def test_a_changed_name_is_refused_by_the_digest(document):
    """Mathematics does not know names."""
    _name(document)
    assert not verify_document(document)
    assert judge(document)


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
    document = document_of((place(Swarm(OUTLINE, CREW[:2]), NEWCOMER),))
    assert judge(document)
    first(document)["improves"] = True
    assert "the newcomer is said to improve" in judge(document).faults[0]


def _worse(document):
    """Replace the robot by a worse one with its true quality, said to be the best."""
    claim = first(document)
    claim["zones"], claim["no_go"], claim["spacing"], claim["runners_up"] = None, [], 0.0, []
    claim["robot"].update(contact=[0.0, -1.0], direction=math.pi / 2)
    rows = [*document["robots"], claim["robot"]]
    B = reference.generators(
        [r["contact"] for r in rows], [r["direction"] for r in rows], [r["limit"] for r in rows],
        document["outline"]["origin"], SWARM.scale,
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
    for robot in document["robots"]:
        robot["mounted"] = True
    document["outline"]["vertices"].insert(1, [2.0, -1.0])
    document["outline"]["edge_names"].append("")
    bollard = {"start": 4.0, "end": 4.0, "name": "", "attachment": None}
    first(document)["zones"] = [
        {**bollard, "half_angle": None, "directions": None},
        {**bollard, "start": 0.0, "half_angle": None, "directions": None},
    ]
    with contextlib.suppress(AnswerInvalid):
        assert not judge(document)


# -- independence ---------------------------------------------------------------------


def test_the_check_shares_no_code_with_the_search():
    """Of the package it imports the form of the file and its digest, and nothing else."""
    tree = ast.parse(Path(verify.__file__).read_text(encoding="utf-8"))
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0
            names.add(node.module)
    ours = {name for name in names if name.startswith("swarmgrasp")}
    form = {f"swarmgrasp.placement.{name}" for name in ("claims", "digest", "document")}
    assert ours <= form | {"swarmgrasp.errors"}
    assert not names & {"numba", "shapely", "importlib"}
