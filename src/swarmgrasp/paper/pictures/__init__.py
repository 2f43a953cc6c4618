"""The report's pictures, in the style of all others."""

from swarmgrasp.paper.pictures.construction import construction
from swarmgrasp.paper.pictures.cross_section import cross_section
from swarmgrasp.paper.pictures.gains import gains
from swarmgrasp.paper.pictures.plateaus import plateau
from swarmgrasp.paper.pictures.relaxation import relaxation
from swarmgrasp.paper.pictures.speed import speed

__all__ = ["construction", "cross_section", "gains", "plateau", "relaxation", "speed"]
