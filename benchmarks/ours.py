"""The parts of the package below its public calls that the benchmarks clock or lend to rivals."""

from swarmgrasp.placement.search import Search
from swarmgrasp.quality.weakest import weakest_of


def bare_quality(generators):
    """Compute the exact quality [N] of generators (n, 3) [N], and nothing else."""
    return weakest_of(generators).quality


def search_of(problem):
    """Return the search for a problem's newcomer, set up."""
    swarm = problem.swarm
    weights = swarm.scale * problem.newcomer.limit
    return Search(swarm.scaled_generators, weights, problem.pieces().rows)


def evaluator(problem):
    """Return the exact quality as a function of many newcomers at once.

    It knows the swarm that is there, so that each newcomer costs only what it changes: the
    fastest objective a general optimiser can be given.

    Returns
    -------
    callable
        From unit wrenches (cos, sin, torque), (m, 3) [1, 1, m], to qualities (m,) [N].
    """
    return search_of(problem).qualities_with
