"""The object: a polygon, its boundary, and places on it."""

from swarmgrasp.outline.outline import Contact, Outline, Stretch

__all__ = ["Contact", "Outline", "Stretch"]
