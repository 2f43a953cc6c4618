"""Linear programs, by HiGHS."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import LinearProgramFailed

TOLERANCE = 1e-10
"""Primal and dual feasibility, the tightest HiGHS takes."""


def minimise(
    cost: ArrayLike,
    matrix: ArrayLike,
    rows: tuple[ArrayLike, ArrayLike],
    columns: tuple[ArrayLike, ArrayLike],
) -> NDArray[np.float64]:
    """Minimise cost . x where the rows of matrix @ x and the columns x lie within bounds.

    Parameters
    ----------
    cost : (n,)
    matrix : (m, n)
    rows, columns : tuple of (m,) and of (n,)
        Lower and upper bounds, which may be infinite; numbers stand for all alike.

    Returns
    -------
    (n,)
        A minimiser, of a problem that must have one.

    Raises
    ------
    LinearProgramFailed
        If HiGHS finds none, by rounding.

    Examples
    --------
    >>> minimise([-1.0, 0.0], [[1.0, 2.0]], rows=(0.0, 4.0), columns=(0.0, np.inf)).tolist()
    [4.0, 0.0]
    """
    import highspy

    A = np.atleast_2d(np.asarray(matrix, dtype=float))
    m, n = A.shape
    program = highspy.HighsLp()
    program.num_row_, program.num_col_ = m, n
    program.col_cost_ = np.asarray(cost, dtype=float)
    program.row_lower_, program.row_upper_ = (np.broadcast_to(b, m).astype(float) for b in rows)
    program.col_lower_, program.col_upper_ = (np.broadcast_to(b, n).astype(float) for b in columns)
    program.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    program.a_matrix_.start_ = np.arange(m + 1, dtype=np.int32) * n
    program.a_matrix_.index_ = np.tile(np.arange(n, dtype=np.int32), m)
    program.a_matrix_.value_ = A.ravel()
    solver = highspy.Highs()
    solver.setOptionValue("output_flag", False)
    solver.setOptionValue("primal_feasibility_tolerance", TOLERANCE)
    solver.setOptionValue("dual_feasibility_tolerance", TOLERANCE)
    solver.passModel(program)
    solver.run()
    status = solver.getModelStatus()
    if status != highspy.HighsModelStatus.kOptimal:
        raise LinearProgramFailed(
            f"HiGHS ended with {solver.modelStatusToString(status)!r} on a program of {m} rows "
            f"and {n} columns; scale the input, whose numbers may be too far apart"
        )
    return np.array(solver.getSolution().col_value)
