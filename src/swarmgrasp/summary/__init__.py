"""What a swarm of any size can do, in a message of fixed size, with bounds that are certain."""

from swarmgrasp.summary.bounds import Bounds
from swarmgrasp.summary.placing import PlacementBounds
from swarmgrasp.summary.summary import Summary

__all__ = ["Bounds", "PlacementBounds", "Summary"]
