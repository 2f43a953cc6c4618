"""The source paper made again: its Algorithm 1 as a baseline, and its figures as a report.

`swarmgrasp.paper.report` writes the report; it is left out here because it draws.
"""

from swarmgrasp.paper.algorithm_1 import Printed, Promise, algorithm_1
from swarmgrasp.paper.attachment import Attachment, nearest_attachment
from swarmgrasp.paper.relaxed import Relaxed, relaxed_optimum

__all__ = [
    "Attachment",
    "Printed",
    "Promise",
    "Relaxed",
    "algorithm_1",
    "nearest_attachment",
    "relaxed_optimum",
]
