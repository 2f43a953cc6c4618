"""Several newcomers at once, one robot elsewhere, and how many it takes (T17)."""

from swarmgrasp.placement.together.how_many import HowMany, how_many
from swarmgrasp.placement.together.moving import Move, Relocation, best_move
from swarmgrasp.placement.together.place import Together, place_together

__all__ = [
    "HowMany",
    "Move",
    "Relocation",
    "Together",
    "best_move",
    "how_many",
    "place_together",
]
