"""The slow truth: plain functions on arrays, written from the formulas alone.

Nothing here imports the package under test. Generators ``B`` are scaled unless said
otherwise: (n, 3) [N, N, N], so that the metric is Euclidean.
"""

import math
from collections import Counter
from fractions import Fraction
from itertools import combinations, pairwise, product

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, linprog, lsq_linear, milp, minimize
from scipy.spatial import ConvexHull

# -- generators and quality -----------------------------------------------------------


def generators(contacts, directions, limits, origin, scale):
    """Compute b_i = scale * limit_i * (cos a_i, sin a_i, r_x sin a_i - r_y cos a_i), r = c - o.

    Contacts (n, 2) [m], directions (n,) [rad], limits (n,) [N], origin (2,) [m] and
    scale (3,) [1, 1, 1/m] give (n, 3) [N, N, N].
    """
    rows = []
    for (x, y), alpha, limit in zip(contacts, directions, limits, strict=True):
        fx, fy = math.cos(alpha), math.sin(alpha)
        torque = (x - origin[0]) * fy - (y - origin[1]) * fx
        rows.append([limit * fx, limit * fy, limit * torque])
    return np.array(rows, dtype=float).reshape(-1, 3) * np.asarray(scale, dtype=float)


def support(B, normals):
    """h(n) = sum_i max(0, n . b_i) for normals (m, 3); returns (m,)."""
    return np.maximum(np.atleast_2d(normals) @ np.reshape(B, (-1, 3)).T, 0.0).sum(axis=1)


def plane_across(b):
    """Two orthonormal vectors, rows of (2, 3), that span the plane b . n = 0."""
    return np.linalg.svd(np.reshape(b, (1, 3)) / np.linalg.norm(b))[2][1:]


def normals_across(b, B):
    """Find the unit normals +-(b x b_k) for all k in the plane across b; at least 4.

    The plane's own axes are among them: any unit normal gives h(n) >= Q, so they cannot
    spoil a minimum, and they stand in where every b_k is parallel to b.
    """
    plane = plane_across(b)
    flat = B @ plane.T
    lengths = np.linalg.norm(flat, axis=1)
    flat = flat[lengths > 0.0] / lengths[lengths > 0.0, None]
    turned = np.column_stack([-flat[:, 1], flat[:, 0]]) @ plane
    half = np.vstack([plane, turned])
    return np.vstack([half, -half])


def facet_normals(B):
    """All candidate facet normals (T2), (m, 3), with h at each, (m,)."""
    B = np.reshape(B, (-1, 3))
    kept = B[np.linalg.norm(B, axis=1) > 0.0]
    if not len(kept):
        normals = np.vstack([np.eye(3), -np.eye(3)])
    else:
        normals = np.vstack([normals_across(b, kept) for b in kept])
    return normals, support(B, normals)


def quality(B):
    """Q = min over n = +-(b_j x b_k)/|b_j x b_k| of sum_i max(0, n . b_i), in newtons (T2).

    Every normal tried is honest, so the result is never below Q by more than rounding.
    """
    return float(facet_normals(B)[1].min())


def exact_quality(B):
    """Compute Q (T2) in fractions, without any rounding but that of the root at the end."""
    rows = [tuple(map(Fraction, row)) for row in np.reshape(B, (-1, 3)).tolist()]
    squares, spans = [], False
    for (a1, a2, a3), (b1, b2, b3) in combinations(rows, 2):
        n = (a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1)
        if any(n):
            products = [sum(x * y for x, y in zip(n, row, strict=True)) for row in rows]
            spans = spans or any(products)
            least = min(sum(max(p, 0) for p in products), sum(max(-p, 0) for p in products))
            squares.append(least**2 / sum(x**2 for x in n))
    return math.sqrt(min(squares)) if spans else 0.0


# -- placement ------------------------------------------------------------------------


def one_sided(p, q, low, high):
    """Split the sector [low, high] where (q - p) x F changes sign, and to widths <= pi.

    Returns a list of (low, high) [rad]. Inside each, the torque of a contact on [p, q]
    lies between p x F and q x F: the condition under which (T8) is a convex set.
    """
    edge = math.atan2(q[1] - p[1], q[0] - p[0]) if tuple(p) != tuple(q) else low
    turns = range(math.floor((low - edge) / math.pi), math.ceil((high - edge) / math.pi) + 1)
    cuts = [edge + k * math.pi for k in turns if low < edge + k * math.pi < high]
    ends = [low, *cuts, high]
    return list(pairwise(ends))


def _piece_rows(p, q, low, high, torque_scale):
    """Rows r with r . (F_x, F_y, torque_scale * tau) <= 0 that make up the cone of (T8)."""
    middle = 0.5 * (low + high)
    side = (q[0] - p[0]) * math.sin(middle) - (q[1] - p[1]) * math.cos(middle)
    near, far = (p, q) if side >= 0.0 else (q, p)  # near x F <= tau <= far x F
    return np.array(
        [
            [math.sin(low), -math.cos(low), 0.0],  # low x F >= 0
            [-math.sin(high), math.cos(high), 0.0],  # F x high >= 0
            [-math.cos(middle), -math.sin(middle), 0.0],
            [-torque_scale * near[1], torque_scale * near[0], -1.0],
            [torque_scale * far[1], -torque_scale * far[0], 1.0],
        ]
    )


def _deepest(cone, tangents, demands, levels):
    """Maximise s with n_k . x >= level_k + s, cone . x <= 0, |F| <= 1 by tangents.

    Returns (s, x), x = (F_x, F_y, scaled tau).
    """
    discs = np.column_stack([np.cos(tangents), np.sin(tangents), np.zeros((len(tangents), 2))])
    rows = np.vstack(
        [
            np.column_stack([cone, np.zeros(len(cone))]),
            discs,
            np.column_stack([-demands, np.ones(len(demands))]),
        ]
    )
    right = np.concatenate([np.zeros(len(cone)), np.ones(len(discs)), -levels])
    answer = linprog(
        [0.0, 0.0, 0.0, -1.0], A_ub=rows, b_ub=right, bounds=[(None, None)] * 3 + [(None, 1e6)]
    )
    assert answer.status == 0, answer.message
    return float(answer.x[3]), answer.x[:3]


def _level_reached(B, cone, metric, level, pool, tolerance):
    """Try to reach a level on one convex piece by cutting planes.

    Minimum over n of h(n) + max(0, n . b) >= t asks n . b >= t - h(n) where h(n) < t.
    Normals are added where the exact quality of B and the answer says the level is
    missed, tangents where the answer's force is longer than 1.
    Returns (reached, best quality seen, the pool with the normals added).
    """
    tangents = np.linspace(0.0, 2.0 * math.pi, 64, endpoint=False)
    best = 0.0
    for _ in range(500):
        heights = support(B, pool)
        asked = heights < level
        demands = pool[asked] * metric
        depth, x = _deepest(cone, tangents, demands, level - heights[asked])
        if depth < -1e-9:
            return False, best, pool
        length = math.hypot(x[0], x[1])
        b = metric * x / max(length, 1.0)
        normals, heights = facet_normals(np.vstack([B, b]))
        best = max(best, float(heights.min()))
        if best >= level - tolerance:
            return True, best, pool
        missed = heights < level - 0.5 * tolerance
        worst = np.argsort(heights[missed])[:20]
        pool = np.vstack([pool, normals[missed][worst]])
        if length > 1.0 + 1e-9:
            tangents = np.append(tangents, math.atan2(x[1], x[0]))
    raise AssertionError("the cutting planes did not settle")


def piece_upper_bound_lp(B, piece, limit, origin, scale, tolerance=1e-6):
    """Maximise Q(B and b) over one piece (T8), by bisection on linear programs.

    Parameters are B scaled, piece = (p, q, alpha_low, alpha_high) with p, q (2,) [m] in the
    outline's frame, limit [N], origin (2,) [m], scale (3,). Returns (upper, lower) [N]:
    upper is refuted by the linear programs, lower reached by a robot of the piece; they
    are at most about `tolerance` apart. Sectors of any width are split as needed.
    """
    B = np.reshape(B, (-1, 3))
    p, q, low, high = piece
    arms = [(c[0] - origin[0], c[1] - origin[1]) for c in (p, q)]
    metric = limit * np.array([scale[0], scale[1], 1.0])
    upper = lower = 0.0
    for start, end in one_sided(*arms, low, high):
        cone = _piece_rows(*arms, start, end, scale[2])
        pool = facet_normals(B)[0]
        reach = max(math.hypot(*arm) for arm in arms) * scale[2]
        under = 0.0
        over = support(B, pool).min() + limit * math.hypot(max(scale[0], scale[1]), reach)
        while over - under > tolerance:
            level = 0.5 * (under + over)
            reached, best, pool = _level_reached(B, cone, metric, level, pool, 0.1 * tolerance)
            under = max(under, best)
            over = over if reached else level
        upper, lower = max(upper, over), max(lower, under)
    return float(upper), float(lower)


def best_on_grid(B, pieces, limit, origin, scale, n_contacts=41, n_directions=73):
    """Best Q(B and b) over a grid of robots allowed by pieces (p, q, alpha_low, alpha_high).

    Returns (quality [N], contact (2,) [m], direction [rad]); never above the optimum.
    """
    B = np.reshape(B, (-1, 3))
    base_normals, base_heights = facet_normals(B)
    best = (-1.0, None, None)
    for p, q, low, high in pieces:
        shares = [0.0] if tuple(p) == tuple(q) else np.linspace(0.0, 1.0, n_contacts)
        angles = [low] if low == high else np.linspace(low, high, n_directions)
        for share, alpha in product(shares, angles):
            contact = np.asarray(p) + share * (np.asarray(q) - np.asarray(p))
            (b,) = generators([contact], [alpha], [limit], origin, scale)
            value = float((base_heights + np.maximum(base_normals @ b, 0.0)).min())
            if value > best[0]:
                value = min(value, float(support(B, normals_across(b, B)).min()))
            if value > best[0]:
                best = (value, contact, float(alpha))
    return best


# -- the wrench set -------------------------------------------------------------------


def corner_hull(B):
    """Convex hull of all 2^n sums of generators: (volume, corners (v, 3)); n <= 12, rank 3."""
    B = np.reshape(B, (-1, 3))
    sums = np.array(list(product([0.0, 1.0], repeat=len(B)))) @ B
    hull = ConvexHull(sums)
    return float(hull.volume), sums[hull.vertices]


def volume(B):
    """Sum of |det(b_i, b_j, b_k)| over all triples."""
    triples = [np.linalg.det(np.array(t)) for t in combinations(np.reshape(B, (-1, 3)), 3)]
    return float(np.abs(triples).sum()) if triples else 0.0


# -- numbers known exactly ------------------------------------------------------------


def _unit(rows):
    """Rows scaled to length 1."""
    rows = np.array(rows, dtype=float)
    return rows / np.linalg.norm(rows, axis=1, keepdims=True)


def _both(rows):
    """Rows and their negatives: segments [-v, v]."""
    return np.vstack([_unit(rows), -_unit(rows)])


def square_of_robots(t, mirrored=False):
    """Scaled generators of 4 (or 8) unit robots pulling on a square of half-side 1, L = 1.

    (1, -t) along +x, (-1, t) along -x, (-t, 1) along +y, (t, -1) along -y.
    """
    rows = []
    for s in (t, -t) if mirrored else (t,):
        contacts = [(1.0, -s), (-1.0, s), (-s, 1.0), (s, -1.0)]
        angles = [0.0, math.pi, 0.5 * math.pi, -0.5 * math.pi]
        rows.append(generators(contacts, angles, [1.0] * 4, (0.0, 0.0), (1.0, 1.0, 1.0)))
    return np.vstack(rows)


PHI = 0.5 * (1.0 + math.sqrt(5.0))
CUBE_CORNERS = [(1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)]
FACE_DIAGONALS = [(1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)]
ICOSAHEDRON = [(0, 1, PHI), (0, 1, -PHI), (1, PHI, 0), (1, -PHI, 0), (PHI, 0, 1), (-PHI, 0, 1)]
TETRAHEDRON = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]

SOLIDS = {
    "cube": (_both(np.eye(3)), 1.0, 6, 8),
    "rhombic dodecahedron": (_both(CUBE_CORNERS), 2.0 * math.sqrt(6.0) / 3.0, 12, 14),
    "rhombic triacontahedron": (
        _both(ICOSAHEDRON),
        2.0 * PHI**2 / math.sqrt(1.0 + PHI**2),
        30,
        32,
    ),
    "truncated octahedron": (_both(FACE_DIAGONALS), math.sqrt(6.0), 14, 24),
    "truncated cuboctahedron": (
        _both([*np.eye(3), *FACE_DIAGONALS]),
        1.0 + 2.0 * math.sqrt(2.0),
        26,
        48,
    ),
    "tetrahedron of four": (_unit(TETRAHEDRON), math.sqrt(6.0) / 3.0, 12, 14),
}
"""Name: (generators (n, 3), exact quality, faces, corners)."""

CLOSED_FORMS = {name: (B, exact) for name, (B, exact, _, _) in SOLIDS.items()}
for _t in (0.2, 0.4, 1.0):
    _q = 2.0 * _t / math.sqrt(1.0 + 2.0 * _t**2)
    CLOSED_FORMS[f"square of four, t = {_t}"] = (square_of_robots(_t), min(1.0, _q))
    CLOSED_FORMS[f"square of eight, t = {_t}"] = (square_of_robots(_t, True), min(2.0, 2.0 * _q))
"""Name: (generators (n, 3), exact quality)."""


# -- criteria ---------------------------------------------------------------------------


def task_support(rows, kind, normals):
    """D(n) (m,): |n|, the greatest n . v or 0 of a polytope, or |rows n| of an ellipsoid."""
    if kind is None:
        return np.linalg.norm(normals, axis=1)
    along = normals @ np.reshape(rows, (-1, 3)).T
    if kind == "polytope":
        return np.maximum(along.max(axis=1), 0.0)
    return np.sqrt((along * along).sum(axis=1))


def quality_by_criterion(B, losing=0, load=(0, 0, 0), rows=None, kind=None):
    """Least (n . load + h(n)) / D(n) over the facet normals of every swarm that a loss leaves.

    All subsets are listed, and the axes' planes with the generators': they split the sphere into
    cones with corners, on each of which the numerator is linear and D convex.
    """
    worst = math.inf
    for gone in combinations(range(len(B)), min(losing, len(B))):
        left = np.delete(np.reshape(B, (-1, 3)), gone, axis=0)
        normals = np.vstack([facet_normals(np.vstack([left, np.eye(3)]))[0], np.eye(3), -np.eye(3)])
        height = support(left, normals) + normals @ np.asarray(load, dtype=float)
        extent = task_support(rows, kind, normals)
        asked = extent > 1e-9
        if (height[~asked] < -1e-9).any():
            return 0.0
        worst = min(worst, float((height[asked] / extent[asked]).min()))
    return max(worst, 0.0)


def quality_of_corners(corners, losing=0):
    """Least quality when each generator is one of a few, (m_i, 3) each: all choices are listed."""
    return min(quality_by_criterion(np.array(B), losing) for B in product(*corners))


# -- capability -----------------------------------------------------------------------


def largest_wind(B, current, wind, losing=0, least=0.0):
    """Find the largest s for which -(current + s wind) is made after any loss of `losing` rows.

    By linear programs over u in [least, 1]^n, one per loss; 0 if one cannot make -current alone.
    Generators (n, 3), current and wind (3,), all in the same coordinates; least (n,) or one.
    """
    B = np.reshape(B, (-1, 3))
    lows = np.broadcast_to(least, len(B))
    size = np.abs(wind).max()
    least = math.inf
    for lost in combinations(range(len(B)), losing):
        kept = np.delete(B, lost, axis=0)
        bounds = [(low, 1.0) for low in np.delete(lows, lost)]
        calm = linprog(np.zeros(len(kept)), A_eq=kept.T, b_eq=-current, bounds=bounds)
        if not calm.success:
            return 0.0
        table = np.column_stack([kept.T, wind / size])
        cost = np.append(np.zeros(len(kept)), -1.0)
        found = linprog(cost, A_eq=table, b_eq=-current, bounds=[*bounds, (0.0, None)])
        least = min(least, found.x[-1] / size)
    return least


# -- push forces ----------------------------------------------------------------------


def least_largest_share(B, wrench):
    """Least t with sum x_i b_i = w and 0 <= x_i <= t (T18), by a linear program; inf if none."""
    n = len(B)
    size = np.linalg.norm(wrench)
    answer = linprog(
        np.append(np.zeros(n), 1.0),
        A_eq=np.column_stack([B.T, np.zeros(3)]) / size,
        b_eq=wrench / size,
        A_ub=np.column_stack([np.eye(n), -np.ones(n)]),
        b_ub=np.zeros(n),
        options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10},
    )
    return float(answer.fun) if answer.status == 0 else math.inf


def least_largest_part(arms, corners, wrench):
    """Least t with forces t times those in the hulls of corners and 0 that make w; inf if none."""
    columns = np.concatenate(
        [
            np.column_stack([F, x * F[:, 1] - y * F[:, 0]])
            for (x, y), F in zip(arms, corners, strict=True)
        ]
    )
    counts = [len(F) for F in corners]
    owner = np.repeat(np.arange(len(counts)), counts)
    parts = (owner == np.arange(len(counts))[:, None]).astype(float)
    answer = linprog(
        np.append(np.zeros(len(columns)), 1.0),
        A_eq=np.column_stack([columns.T, np.zeros(3)]),
        b_eq=wrench,
        A_ub=np.column_stack([parts, -np.ones(len(counts))]),
        b_ub=np.zeros(len(counts)),
    )
    return float(answer.fun) if answer.status == 0 else math.inf


def least_squares_shares(B, wrench, top, weight=1e6):
    """Least sum of squares of x in [0, top]^n with sum x_i b_i = w.

    By least squares in which a miss of the wrench weighs much, and is then asked for on top.
    """
    size = np.linalg.norm(B)
    rows = np.vstack([np.eye(len(B)), weight * B.T / size])
    asked = wrench
    for _ in range(50):
        right = np.concatenate([np.zeros(len(B)), weight * asked / size])
        x = lsq_linear(rows, right, (0.0, top), method="bvls", tol=1e-15, max_iter=10_000).x
        miss = wrench - x @ B
        if np.linalg.norm(miss) <= 1e-14 * size:
            break
        asked = asked + miss
    return x


def nearest_wrench(B, wrench):
    """Nearest point of {sum x_i b_i, 0 <= x_i <= 1} to a wrench (3,)."""
    return lsq_linear(B.T, wrench, (0.0, 1.0), method="bvls", tol=1e-15, max_iter=10_000).x @ B


# -- sensitivities --------------------------------------------------------------------


def one_sided_slope(quality_at, step):
    """Differentiate a function of x >= 0 at 0, by Richardson's rule from three values."""
    return (4.0 * quality_at(0.5 * step) - quality_at(step) - 3.0 * quality_at(0.0)) / step


# -- several newcomers ------------------------------------------------------------------


def best_together(B, candidates, count):
    """Best quality of B (n, 3) with `count` of some candidates (m, 3), each any number of times.

    A mixed-integer program: max t, t <= h(n) + sum_j x_j max(0, n . c_j) for the normals found
    so far, sum x = count; the facet normals of each answer are added until it is exact.
    """
    m, normals = len(candidates), np.vstack([np.eye(3), -np.eye(3)])
    cost = np.append(np.zeros(m), -1.0)
    total = LinearConstraint(np.append(np.ones(m), 0.0), count, count)
    bounds = Bounds(np.zeros(m + 1), np.append(np.full(m, float(count)), np.inf))
    while True:
        table = np.column_stack([-np.maximum(normals @ candidates.T, 0.0), np.ones(len(normals))])
        rows = LinearConstraint(table, -np.inf, support(B, normals))
        whole = np.append(np.ones(m), 0.0)
        found = milp(cost, integrality=whole, bounds=bounds, constraints=[total, rows])
        chosen = np.repeat(candidates, np.round(found.x[:m]).astype(int), axis=0)
        facets, heights = facet_normals(np.vstack([np.reshape(B, (-1, 3)), chosen]))
        if heights.min() >= -found.fun - 1e-7:
            return float(heights.min())
        normals = np.vstack([normals, facets[np.argsort(heights)[:20]]])


# -- the source paper -----------------------------------------------------------------


def most_in_cylinder(B, size, rounds=60, close=5e-5):
    """Bound the quality that any b = size * x, |(x_1, x_2)| <= 1, |x_3| <= 1, brings (T10).

    Any normals with h(n) <= t show that none exceeds the largest t that all of
    t <= h(n) + n . b allow, over a polygon round the disc; those brought by the best b so far
    are added until that b comes close. Returns the least bound that they show [N].
    """
    turn = np.arange(256) * math.tau / 256
    disc = np.column_stack([np.cos(turn), np.sin(turn), np.zeros((256, 2))])
    normals, heights = facet_normals(B)
    bound, best = math.inf, quality(B)
    for _ in range(rounds):
        level = best + 0.5 * (min(bound, best + np.linalg.norm(size)) - best)
        low = heights <= level
        rows = np.column_stack([-normals[low] * size, np.ones(low.sum())])
        found = linprog(
            [0.0, 0.0, 0.0, -1.0],
            np.vstack([disc, rows]),
            np.concatenate([np.ones(256), heights[low]]),
            bounds=[(-2, 2), (-2, 2), (-1, 1), (None, None)],
        )
        bound = min(bound, max(-found.fun, level))
        x = found.x[:3]
        x[:2] /= max(1.0, math.hypot(x[0], x[1]))
        both = np.vstack([B, x * size])
        best = max(best, quality(both))
        if bound - best <= close:
            break
        brought = normals_across(x * size, B)
        normals = np.vstack([normals, brought])
        heights = np.append(heights, support(B, brought))
    return bound


def most_of_task(B, rows):
    """Return the largest s at which robots of generators B make s times each row, by programs."""
    most = math.inf
    for row in np.asarray(rows, dtype=float):
        size = np.linalg.norm(row)
        unknown = np.append(np.zeros(len(B)), -1.0)  # shares of the limits, and s size
        matrix = np.column_stack([np.asarray(B).T, -row / size])
        bounds = [(0.0, 1.0)] * len(B) + [(0.0, None)]
        most = min(
            most, linprog(unknown, A_eq=matrix, b_eq=np.zeros(3), bounds=bounds).x[-1] / size
        )
    return most


def check_closed(mesh):
    """Every side of a face meets exactly one other face, and V - E + F = 2."""
    sides = Counter(
        side for face in mesh.faces for side in zip(face, face[1:] + face[:1], strict=True)
    )
    assert set(sides.values()) == {1}
    assert all((b, a) in sides for a, b in sides)
    assert len(mesh.vertices) - len(mesh.edges) + len(mesh.faces) == 2


# -- robots as sets of forces -----------------------------------------------------------


def force_support(robot, p):
    """Return the greatest F . p over the forces F of a robot, for vectors p (m, 2); (m,).

    From its fields: limits, reverse limit, steering, friction, least force or envelope.
    """
    turn, size = np.arctan2(p[:, 1], p[:, 0]) - robot.direction, np.hypot(p[:, 0], p[:, 1])
    if robot.sectors is not None:  # of the hull
        turns = [np.linspace(*sector, 2001) for sector in robot.sectors]
        turns = np.concatenate(turns)
        rim = robot.limit * np.column_stack([np.cos(turns), np.sin(turns)])
        return np.maximum((p @ rim.T).max(axis=1), 0.0)
    if robot.envelope is not None or robot.friction:
        limit, least, mu = robot.limit, robot.least, robot.friction or 0.0
        corners = robot.envelope or [(u, s * mu * u) for u in (limit, least) for s in (1.0, -1.0)]
        local = size[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
        return (local @ np.array(corners).T).max(axis=1)
    off = np.abs(np.arctan2(np.sin(turn), np.cos(turn)))
    ahead = size * np.cos(np.maximum(off - robot.steers, 0.0))
    back = size * np.cos(np.maximum(math.pi - off - robot.steers, 0.0))
    other = robot.least * ahead if robot.least else robot.reverse_limit * back
    return np.maximum(robot.limit * ahead, other)


def height_of_sets(swarm, normals, losing=0, load=(0, 0, 0), failures=()):
    """H(n) (m,) of robots of any kind at normals (m, 3), in the metric's coordinates (T20, T25)."""
    n, heights = normals * swarm.scale, []
    worths = []
    for robot in swarm:
        x, y = np.subtract(robot.contact, swarm.outline.origin)
        worths.append(force_support(robot, n[:, :2] + n[:, 2:] * np.array([-y, x])))
    for failure in failures or [()]:
        machines = {}
        for robot, worth in zip(swarm, worths, strict=True):
            if not {robot.name, robot.group} & set(failure):
                key = robot.group or (robot.name,)
                machines[key] = machines.get(key, 0.0) + worth
        rows = np.array([*machines.values(), np.zeros(len(normals))])
        lost = np.sort(np.maximum(rows, 0.0), axis=0)[::-1][:losing].sum(axis=0)
        heights.append(rows.sum(axis=0) - lost)
    return normals @ (np.asarray(load, dtype=float) * swarm.scale) + np.min(heights, axis=0)


def sector_choices(robot, parts=2):
    """Return the sectors of a robot, those wider than half a turn cut in convex parts."""
    found = []
    way, half = robot.direction, robot.steers
    for start, end in robot.sectors or [(way - half, way + half)]:
        count = 1 if end - start <= math.pi + 1e-9 else parts
        ends = np.linspace(start, end, count + 1)
        found += [(float(a), float(b)) for a, b in pairwise(ends)]
    return found


def least_factor_of_sectors(robots, arms, scale, wrench):
    """Return by how much limits are to be multiplied to make a wrench, over all choices of sectors.

    Each sector is a fan of rays 0.01 rad apart, in a linear program for each choice; fans reach
    less far than sectors, by 2e-5. Wrench (3,) [N, N, N m]; robots that push in sectors only.
    """
    least = math.inf
    for choice in product(*(sector_choices(robot) for robot in robots)):
        rows = []
        for robot, (x, y), (start, end) in zip(robots, arms, choice, strict=True):
            turns = np.linspace(start, end, max(2, math.ceil((end - start) / 0.01) + 1))
            fx, fy = robot.limit * np.cos(turns), robot.limit * np.sin(turns)
            rows.append(np.column_stack([fx, fy, x * fy - y * fx]) * scale)
        counts = [len(row) for row in rows]
        owners = np.repeat(np.arange(len(rows)), counts)
        cost = np.append(np.zeros(len(owners)), 1.0)
        sums = np.column_stack([(owners == i).astype(float) for i in range(len(rows))]).T
        found = linprog(
            cost,
            A_ub=np.column_stack([sums, -np.ones(len(rows))]),
            b_ub=np.zeros(len(rows)),
            A_eq=np.column_stack([np.vstack(rows).T, np.zeros(3)]),
            b_eq=np.asarray(wrench) * scale,
        )
        least = min(least, float(found.fun)) if found.status == 0 else least
    return least


def quality_of_sets(swarm, seed, near, descents, losing=0, load=(0, 0, 0), task=None, failures=()):
    """Return the least H / D that 2 000 directions and descents from the best of them find.

    An upper bound of the quality, and after two descents nearly always the quality. `near` (3,) is
    among the directions, and others are around it.
    """
    rng = np.random.default_rng(seed)
    kind = None if task is None else "polytope" if hasattr(task, "vertices") else "ellipsoid"
    rows = None if task is None else task.generators * swarm.scale

    def value(normals):
        """H / D (m,); inf where the task asks for next to nothing."""
        normals = np.reshape(normals, (-1, 3))
        extent = task_support(rows, kind, normals)
        reach = np.linalg.norm(normals, axis=1)
        reach = reach * (1.0 if rows is None else np.linalg.norm(rows, axis=1).max())
        height = height_of_sets(swarm, normals, losing, load, failures)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(extent > 1e-6 * reach, height / extent, np.inf)

    around = np.reshape(near, (1, 3)) + 0.03 * rng.normal(size=(200, 3))
    normals = np.vstack([rng.normal(size=(1800, 3)), around, [near], np.eye(3), -np.eye(3)])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    values = value(normals)
    best = float(values.min())
    for start in normals[np.argsort(values)[:descents]]:
        if np.isfinite(value(start)[0]):
            options = {"xatol": 1e-9, "fatol": 1e-13 * abs(best), "maxiter": 400}
            found = minimize(
                lambda n: float(value(n)[0]), start, method="Nelder-Mead", options=options
            )
            best = min(best, float(found.fun))
    return max(best, 0.0)
