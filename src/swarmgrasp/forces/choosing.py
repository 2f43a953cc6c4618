"""Push forces of robots whose sectors have gaps between: which sector for which wrench (T28)."""

import numpy as np

from swarmgrasp.forces.answer import Array, robots_of
from swarmgrasp.forces.certificate import Kept, SectorsProof
from swarmgrasp.forces.rows import Rows, set_rows
from swarmgrasp.forces.wanted import Triple
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.choices import OPEN, Asked, Choices, Found, Taken
from swarmgrasp.swarm.sectors import Sectors

TURN = 2.0 * np.pi
INSIDE = 1e-10
"""Of its limit: by how much a force beside a sector is in it."""


def gap_rows(swarm: Swarm, wrenches: Array, load: Triple) -> Rows:
    """Return the best forces over all choices of sectors for wrenches (m, 3), and why they are.

    All in the metric's coordinates. Most are found with the gaps filled, by forces that all lie in
    sectors; for others, sectors are chosen where they do not.

    Raises
    ------
    ForcesNotProven
        If rounding decides.
    """
    choosing = _Choosing(swarm, load)
    filled = set_rows(swarm.filled, wrenches, load)
    parts, proofs = [], []
    for k, wrench in enumerate(wrenches):
        found = choosing.best(wrench, filled.one(k))
        parts.append(choosing.whole(wrench, found))
        proofs.append(choosing.proof(found))
    return Rows.joined(parts, tuple(proofs)) if parts else filled


class _Choosing:
    """The choices of a swarm, asked for what they cost for wrenches."""

    def __init__(self, swarm: Swarm, load: Triple) -> None:
        self._swarm, self._load = swarm, load
        self._choices = Choices(swarm)
        self._gaps = [swarm.rare.gaps[i] for i in self._choices.rows]
        robots = robots_of(swarm)
        self._rests = robots.rests
        self._reaches = np.where(robots.reaches > 0.0, robots.reaches, np.inf)

    def best(self, wrench: Array, filled: Rows) -> Found:
        """Find the best choice for a wrench, given what is found for it with all gaps filled."""

        def ask(taken: Taken) -> Asked:
            """Return how near to the wrench a choice comes, by what shares, and their squares."""
            if taken == self._choices.none:
                return self._asked(taken, filled)
            return self._asked(taken, self._rows(taken, wrench))

        return self._choices.least(ask)

    def whole(self, wrench: Array, found: Found) -> Rows:
        """Return the row of a choice; what is needed out of reach, in the sectors pushed in."""
        rows: Rows = found.asked.what
        if rows.shortfalls[0] == 0.0 or OPEN not in found.taken:
            return rows
        forces = rows.vectors[0, list(self._choices.rows)]
        taken = tuple(
            now if now != OPEN else int(np.argmin([_aside(force, (part,)) for part in parts]))
            for now, force, parts in zip(found.taken, forces, self._choices.options, strict=True)
        )
        return rows._replace(needed=self._rows(taken, wrench).needed)

    def proof(self, found: Found) -> SectorsProof:
        """Return why no other choice is better."""
        others = tuple((self._kept(t), asked.what.normals[0, 0]) for t, asked in found.others)
        return SectorsProof(self._kept(found.taken), others, found.is_best)

    def _rows(self, taken: Taken, wrench: Array) -> Rows:
        """Return what the kernel finds for a choice."""
        return set_rows(self._choices.swarm(taken), wrench[None], self._load)

    def _kept(self, taken: Taken) -> Kept:
        """Return the sectors of a choice, by the robots' rows."""
        return tuple(self._choices.sectors(taken).items())

    def _asked(self, taken: Taken, rows: Rows) -> Asked:
        """Return the cost of a choice, and the robot whose force is farthest in a gap."""
        vectors = rows.vectors[0]
        aside = [
            _aside(vectors[i], gaps) / self._swarm.limits[i] if now == OPEN else 0.0
            for i, gaps, now in zip(self._choices.rows, self._gaps, taken, strict=True)
        ]
        split = int(np.argmax(aside))
        is_whole = aside[split] <= INSIDE
        parts = (vectors - self._rests) / self._reaches[:, None]
        squares = float((parts**2).sum()) if is_whole or rows.is_least_squares[0] else 0.0
        short = float(rows.shortfalls[0])
        top = float(rows.shares[0].max(initial=0.0)) if short > 0.0 else float(rows.needed[0])
        cost = (short, top, squares)
        return Asked(cost, None if is_whole else split, rows)


def _aside(force: Array, sectors: Sectors) -> float:
    """Return how far a force (2,) [N, N] lies beside the nearest of some sectors [N]."""
    size, way = float(np.hypot(*force)), float(np.arctan2(force[1], force[0]))
    off = min(
        max(min((way - start) % TURN - (end - start), (start - way) % TURN), 0.0)
        for start, end in sectors
    )
    return size * float(np.sin(min(off, 0.25 * TURN)))
