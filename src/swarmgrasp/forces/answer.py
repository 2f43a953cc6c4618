"""The forces that make a wrench, or many wrenches."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.forces.certificate import ForcesCertificate, SectorsProof
from swarmgrasp.frozen import Frozen, read_only
from swarmgrasp.plain import Answer, picked
from swarmgrasp.swarm import Swarm
from swarmgrasp.verify import Verdict
from swarmgrasp.verify.forces import Claim, faults_of
from swarmgrasp.verify.pushes import Robots

Array = NDArray[np.float64]
OTHER_SECTORS = "that no other choice of sectors serves better: there are too many"


@dataclass(frozen=True, eq=False)
class Forces(Frozen, Answer):
    """How hard each robot pushes to make a wrench, or the nearest there is.

    Attributes
    ----------
    swarm : Swarm
    wanted : (3,) [N, N, N m]
        The wrench the object was to receive.
    load : (3,) [N, N, N m]
        The part of it that the environment exerts; the robots exert the rest.
    vectors : (n, 2) [N, N]
        The force of each robot on the object, in the object's frame.
    shares : (n,)
        What each force is of the largest the robot can exert that way, within [0, 1]; of a robot
        with a least force, how far it is from there to its limit.
    needed : float
        The least largest share that makes the wanted wrench. Above 1 it is out of reach: the
        limits would have to be so many times as large, or infinitely so where no force of these
        robots helps; of robots with gaps between their sectors, in those they push in now.
    shortfall : float [N]
        How far from the wanted wrench the nearest attainable one is, in the metric; 0 if it is
        attained.
    is_least_squares : bool
        Whether the sum of squares is the least too. It always is for robots that push along one
        ray each, and hardly ever not for others, at the limit of what they reach.
    certificate : ForcesCertificate
        The proof that no other forces are better.
    """

    swarm: Swarm
    wanted: Array
    load: Array
    vectors: Array
    shares: Array
    needed: float
    shortfall: float
    is_least_squares: bool
    certificate: ForcesCertificate

    kind = "forces"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data; shares and forces in the robots' order."""
        return picked(
            self, "swarm", "wanted", "load", "vectors", "shares", "forces", "directions", "wrench",
            "missing", "shortfall", "largest_share", "needed", "is_degraded", "is_least_squares",
            "certificate",
        )  # fmt: skip

    @cached_property
    def forces(self) -> Array:
        """(n,) [N]: the size of each robot's force, or of each of the two of a couple."""
        return read_only(_sizes(self.vectors) * self.swarm.nearness)

    @cached_property
    def directions(self) -> Array:
        """(n,) [rad]: where each force points; a robot's own direction for none."""
        return read_only(_directions(self.vectors, self.swarm))

    @cached_property
    def wrench(self) -> Array:
        """(3,) [N, N, N m]: what the object receives, from the robots and the environment."""
        return read_only(_wrenches(self.vectors, self.swarm) + self.load)

    @property
    def missing(self) -> Array:
        """(3,) [N, N, N m]: what the wanted wrench has beyond the one made."""
        return self.wanted - self.wrench

    @property
    def largest_share(self) -> float:
        """The largest share of any robot, within [0, 1]."""
        return float(self.shares.max(initial=0.0))

    @property
    def is_degraded(self) -> bool:
        """Whether the wanted wrench is out of reach, and a nearest one made instead."""
        return self.shortfall > 0.0

    @property
    def normal(self) -> Array:
        """(3,): the unit direction, in the metric's coordinates, that limits; 0 for no wrench.

        At this largest share the robots exert no more along it.
        """
        normals = self.certificate.normals
        return normals[0] if len(normals) else np.zeros(3)

    def verify(self) -> Verdict:
        """Check that no other shares are better, by code that shares nothing with the solver.

        Returns
        -------
        Verdict
            True in a condition when all claims hold; its faults say which do not.
        """
        proof = self.certificate.sectors
        trusted = () if proof is None or proof.is_best else (OTHER_SECTORS,)
        return Verdict(tuple(faults_of(self._claim())), unchecked=trusted)

    def _claim(self) -> Claim:
        """Return what is claimed, as plain data."""
        swarm, proof = self.swarm, self.certificate.sectors
        return Claim(
            robots_of(swarm), (*swarm.force_weights, swarm.characteristic_length), self.wanted,
            self.load, self.wrench, self.vectors, self.shares, self.needed, self.shortfall,
            self.is_least_squares, self.certificate.normals, self.certificate.price,
            *(() if proof is None else (proof.kept, proof.others, proof.is_best)),
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class ForcesAlong(Frozen, Answer):
    """How hard each robot pushes for each of many wrenches; an item is the `Forces` of one.

    Attributes
    ----------
    swarm : Swarm
    wanted : (m, 3) [N, N, N m]
    load : (3,) [N, N, N m]
    vectors : (m, n, 2) [N, N]
    shares : (m, n)
    needed : (m,)
    shortfalls : (m,) [N]
    is_least_squares : (m,)
        As in `Forces`.
    normals : (m, 3, 3)
    prices : (m, 3) [1/N]
        The certificates; normals that are not needed are 0.
    sectors : tuple of SectorsProof
        Their parts for each wrench, if robots have sectors with gaps between; otherwise none.
    """

    swarm: Swarm
    wanted: Array
    load: Array
    vectors: Array
    shares: Array
    needed: Array
    shortfalls: Array
    is_least_squares: NDArray[np.bool_]
    normals: Array
    prices: Array
    sectors: tuple[SectorsProof, ...] = ()

    kind = "forces along"

    def to_data(self) -> dict[str, Any]:
        """Return questions and answers as plain data; shares and forces in the robots' order."""
        return picked(
            self, "swarm", "load", "wanted", "vectors", "shares", "forces", "directions",
            "wrenches", "shortfalls", "largest_shares", "needed", "is_degraded",
            "is_least_squares", "normals", "prices", "sectors",
        )  # fmt: skip

    def __len__(self) -> int:
        """Return the number of wrenches."""
        return len(self.wanted)

    def __getitem__(self, index: int) -> Forces:
        """Return the forces of one wrench."""
        normals = self.normals[index]
        return Forces(
            self.swarm,
            self.wanted[index],
            self.load,
            self.vectors[index],
            self.shares[index],
            float(self.needed[index]),
            float(self.shortfalls[index]),
            bool(self.is_least_squares[index]),
            ForcesCertificate(
                normals[normals.any(axis=1)],
                self.prices[index],
                self.sectors[index] if self.sectors else None,
            ),
        )

    def __iter__(self) -> Iterator[Forces]:
        """Go through the wrenches."""
        return (self[index] for index in range(len(self)))

    @cached_property
    def forces(self) -> Array:
        """(m, n) [N]: the size of each robot's force for each wrench."""
        return read_only(_sizes(self.vectors) * self.swarm.nearness)

    @cached_property
    def directions(self) -> Array:
        """(m, n) [rad]: where each force points; a robot's own direction for none."""
        return read_only(_directions(self.vectors, self.swarm))

    @cached_property
    def wrenches(self) -> Array:
        """(m, 3) [N, N, N m]: what the object receives."""
        return read_only(_wrenches(self.vectors, self.swarm) + self.load)

    @property
    def missing(self) -> Array:
        """(m, 3) [N, N, N m]: what the wanted wrenches have beyond those made."""
        return self.wanted - self.wrenches

    @property
    def largest_shares(self) -> Array:
        """(m,): the largest share of any robot for each wrench."""
        return np.asarray(self.shares.max(axis=1, initial=0.0))

    @property
    def is_degraded(self) -> NDArray[np.bool_]:
        """(m,): which wrenches are out of reach."""
        return self.shortfalls > 0.0

    def verify(self) -> Verdict:
        """Check each wrench as `Forces.verify` does; faults begin with its index."""
        verdicts = [(f"wrench {i}: ", found.verify()) for i, found in enumerate(self)]
        return Verdict(
            tuple(where + fault for where, v in verdicts for fault in v.faults),
            unchecked=tuple(where + what for where, v in verdicts for what in v.unchecked),
        )


def robots_of(swarm: Swarm) -> Robots:
    """Return what is said of robots, as plain data."""
    return Robots(
        swarm.contacts - swarm.outline.origin, swarm.directions, swarm.limits,
        swarm.reverse_limits, swarm.steers, swarm.frictions, swarm.leasts, swarm.rare.envelopes,
        swarm.rare.gaps,
    )  # fmt: skip


def _sizes(vectors: Array) -> Array:
    """Return the sizes (..., n) [N] of forces (..., n, 2)."""
    return np.asarray(np.hypot(vectors[..., 0], vectors[..., 1]))


def _directions(vectors: Array, swarm: Swarm) -> Array:
    """Return the directions (..., n) [rad] of forces (..., n, 2); of none, the robot's own."""
    turns = np.arctan2(vectors[..., 1], vectors[..., 0])
    return np.where(vectors.any(axis=-1), turns, swarm.directions)


def _wrenches(vectors: Array, swarm: Swarm) -> Array:
    """Return the wrench (..., 3) [N, N, N m] of forces (..., n, 2) together."""
    x, y = (swarm.contacts - swarm.outline.origin).T
    torque = vectors[..., 1] @ x - vectors[..., 0] @ y
    return np.concatenate([vectors.sum(axis=-2), torque[..., None]], axis=-1)
