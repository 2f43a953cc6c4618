"""Push forces by Clarabel, a solver of cone programs: the same two questions in a row."""

import clarabel
import numpy as np
from scipy import sparse

SLACK = 1e-6
"""How far above the least largest share the least sum of squares may go."""


def program(swarm, wrench):
    """Return A, b and cones over s and all forces: each in s times its set, together the wrench."""
    n = len(swarm)
    equal, least, round_ = [], [], []
    arms = swarm.contacts - swarm.outline.origin
    for k, target in enumerate(wrench):
        row = np.zeros(1 + 2 * n)
        row[1::2], row[2::2] = [(1, 0), (0, 1), (-arms[:, 1], arms[:, 0])][k]
        equal.append((row, target))

    def along(i, way, share=0.0):
        """Return the row of share s - way . F_i."""
        row = np.zeros(1 + 2 * n)
        row[0], row[1 + 2 * i : 3 + 2 * i] = share, -np.asarray(way)
        return row

    for i, robot in enumerate(swarm):
        c, s = np.cos(robot.direction), np.sin(robot.direction)
        if not robot.steers:
            equal.append((along(i, (-s, c)), 0.0))
            least += [along(i, (-c, -s)), along(i, (c, s), robot.limit)]
            continue
        round_ += [along(i, (0, 0), robot.limit), along(i, (-1, 0)), along(i, (0, -1))]
        if robot.steers < np.pi:
            for side in (-1.0, 1.0):
                end = robot.direction + side * robot.steers
                least.append(along(i, (-side * np.sin(end), side * np.cos(end))))
    rows = np.array([row for row, _ in equal] + [-row for row in least + round_])
    b = np.array([target for _, target in equal] + [0.0] * len(least + round_))
    cones = [clarabel.ZeroConeT(len(equal)), clarabel.NonnegativeConeT(len(least))]
    return rows, b, cones + [clarabel.SecondOrderConeT(3)] * (len(round_) // 3)


def solve(P, q, rows, b, cones):
    """Return the solution of one program."""
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    square, matrix = sparse.csc_matrix(P), sparse.csc_matrix(rows)
    return clarabel.DefaultSolver(square, q, matrix, b, cones, settings).solve()


def forces(swarm, wrench):
    """Return the least largest share, the least sum of squares beside it, and the solver's time."""
    rows, b, cones = program(swarm, wrench)
    size = rows.shape[1]
    q = np.zeros(size)
    q[0] = 1.0
    first = solve(np.zeros((size, size)), q, rows, b, cones)
    share = first.x[0]
    weights = np.concatenate([[0.0], 2.0 / np.repeat(swarm.limits, 2) ** 2])
    fixed = np.zeros(size)
    fixed[0] = 1.0
    rows, b = np.vstack([fixed, rows]), np.concatenate([[share * (1.0 + SLACK)], b])
    second = solve(np.diag(weights), np.zeros(size), rows, b, [clarabel.ZeroConeT(1), *cones])
    return share, second.obj_val, first.solve_time + second.solve_time
