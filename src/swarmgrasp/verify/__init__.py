"""The check of every answer, by code that shares nothing with what found it."""

from swarmgrasp.verify.placement import verify_document
from swarmgrasp.verify.verdict import Verdict

__all__ = ["Verdict", "verify_document"]
