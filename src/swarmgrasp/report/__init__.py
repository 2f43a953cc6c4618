"""One sheet about one job, to be read, printed and signed."""

from swarmgrasp.report.assumptions import assumptions
from swarmgrasp.report.question import outline_facts, question
from swarmgrasp.report.sheet import Origin, Section, Sheet

__all__ = ["Origin", "Section", "Sheet", "assumptions", "outline_facts", "question"]
