"""Where the next robot goes, with a proof that no place is better."""

from swarmgrasp.placement.answer import Placement, RunnerUp
from swarmgrasp.placement.certificate import Certificate, Proof
from swarmgrasp.placement.document import parse_answer, read_answer, write_answer
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import place, place_sequence
from swarmgrasp.placement.verify import Verdict, verify_document

__all__ = [
    "Certificate",
    "Placement",
    "Problem",
    "Proof",
    "RunnerUp",
    "Verdict",
    "parse_answer",
    "place",
    "place_sequence",
    "read_answer",
    "verify_document",
    "write_answer",
]
