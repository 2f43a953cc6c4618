"""How good a grasp is: one module per quality."""

from swarmgrasp.quality.max_transfer import ForceClosure, Quality, quality
from swarmgrasp.quality.weakest import qualities
from swarmgrasp.quality.words import wrench_words

__all__ = ["ForceClosure", "Quality", "qualities", "quality", "wrench_words"]
