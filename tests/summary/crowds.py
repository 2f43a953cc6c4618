"""Crowds of generators to summarise, easy and hard."""

import numpy as np

from swarmgrasp.summary import Summary

KINDS = (
    "round",
    "flat",
    "along a line",
    "one sided",
    "clustered",
    "on the axes",
    "opposite",
    "limits",
    "identical",
    "on bin edges",
)


def crowd(kind, seed, n):
    """Return n generators (n, 3) [N] of a kind."""
    rng = np.random.default_rng(seed)
    B = rng.normal(size=(n, 3))
    if kind == "flat":
        B[:, 2] = B @ [0.3, -0.2, 0.0]
    elif kind == "along a line":
        B = np.outer(rng.normal(size=n), [0.3, 0.9, -0.2])
    elif kind == "one sided":
        B = np.abs(B)
    elif kind == "clustered":
        B = rng.normal(size=(6, 3))[rng.integers(6, size=n)] + 0.03 * B
    elif kind == "on the axes":
        B = np.eye(3)[rng.integers(3, size=n)] * rng.choice([-1.0, 1.0, 2.0], (n, 1))
    elif kind == "opposite":
        B = np.vstack(
            [B[: (n + 1) // 2], -B[: n // 2] * (1.0 + 1e-9 * rng.normal(size=(n // 2, 1)))]
        )
    elif kind == "limits":
        B *= 10.0 ** rng.uniform(-12.0, 12.0, (n, 1))
    elif kind == "identical":
        B = np.tile(B[:5], (n // 5 + 1, 1))[:n]
    elif kind == "on bin edges":
        B = np.tan(0.25 * np.pi * rng.integers(-2, 3, (n, 3)) / 2.0)
    return B


def summary_of(kind, seed, n, bins=108):
    """Return the summary of a crowd."""
    return Summary.from_generators(crowd(kind, seed, n), bins)


def directions(seed, count=200):
    """Return unit normals (count + 6, 3): some at random, and the axes both ways."""
    normals = np.random.default_rng(seed).normal(size=(count, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return np.vstack([normals, np.eye(3), -np.eye(3)])
