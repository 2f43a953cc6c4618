"""What the report's statements rest on, in words: the labels are those of `docs/theory.md`."""

from collections.abc import Mapping
from typing import Final

THEORY: Final[Mapping[str, str]] = {
    "T1": (
        "The quality is the radius of the largest ball around the origin inside the wrench "
        "set, the sum of all robots' segments: the least of its support function over all "
        "unit directions. It is above 0 exactly when the grasp is force closed, which takes "
        "at least 4 robots."
    ),
    "T2": (
        "That least is attained at the normal of a facet, and each facet's normal is at right "
        "angles to two robots' wrenches. Generators that do not span the space have quality "
        "0."
    ),
    "T5": (
        "Of all robots on the line between two, none is worse than both: what reaches a level "
        "is convex. It may be flat, too, which is where local solvers stop."
    ),
    "T7": (
        "A robot cannot make every wrench with |F| ≤ 1 and |τ| ≤ r_max, the set that the "
        "paper searches: its torque is tied to its force by its contact."
    ),
    "T8": (
        "What robots can really make is a union of convex pieces: one for each straight part "
        "of the boundary and each range of directions."
    ),
    "T9": (
        "On a piece, the directions that reach a level are arcs, which follow exactly from "
        "the facets below that level; bisection on the level ends at the best robot."
    ),
    "T10": (
        "A few directions with weights prove of a piece that no robot on it does better than "
        "a bound. Whoever has them needs neither the search nor trust in it."
    ),
    "T11": (
        "Sorting the robots' wrenches in the plane across each of them lists all facets in "
        "O(N² log N)."
    ),
    "T12": (
        "For large swarms branch and bound on the sphere of directions finds the least "
        "without listing all facets."
    ),
    "T17": (
        "If the quality is attained in two opposite directions, as in every balanced swarm, "
        "no single newcomer raises it: what helps one way cannot help the other."
    ),
}
"""Sentences by label."""
