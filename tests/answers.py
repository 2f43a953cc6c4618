"""One question with everything in it, and its answer as a document."""

from functools import cache

from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Zone, place
from swarmgrasp.answer_file import document_of
from swarmgrasp.placement import Problem
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.digest import digest_of

OUTLINE = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)], edge_names=["s", "e", "n", "w"])
CREW = [
    Robot((-1.5, -1), 1.5, 1.2, "Alva"),
    Robot((1.2, 1), 1.2, 1.0, "Bram"),
    Robot((2, 0.4), 3.0, 0.8, "Cato"),
    Robot((0.5, 1), -1.8, 1.0, "Dina"),
    Robot((-2, -0.3), 0.2, 1.2, "Ebbe"),
]
SWARM = Swarm(OUTLINE, CREW, 1.5)
NEWCOMER = Newcomer(1.0, "push", 0.4, "Fred")
ZONES = (Zone(Stretch(6.3, 8.0, "quay")), Zone(Stretch(9.0, 9.0, "bollard"), "push", 0.2))
QUESTION = Problem(SWARM, NEWCOMER, ZONES, (Stretch(7.1, 7.3, "ramp"),), 0.4)


@cache
def honest_document():
    """Return a document with zones, a bollard, a no-go stretch, spacing and runners-up."""
    answer = place(
        SWARM, NEWCOMER, ZONES, no_go=QUESTION.no_go, spacing=QUESTION.spacing, runners_up=0.0
    )
    return document_of(answer)


def judge(document):
    """Verify a document whose digest fits again, so that only the mathematics can object."""
    document["digest"] = digest_of(document)
    return verify_document(document)


def first(document):
    """Return the only placement."""
    return document["placements"][0]


def asked(document):
    """Return its question."""
    return document["problem"]
