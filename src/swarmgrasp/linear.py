"""Linear programs, by HiGHS."""

from typing import Any, NamedTuple

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
    A = np.atleast_2d(np.asarray(matrix, dtype=float))
    m, n = A.shape
    solver = _solver(presolve=True)
    solver.passModel(_model(cost, A, rows, columns))
    solver.run()
    if not _is_solved(solver):
        status = solver.modelStatusToString(solver.getModelStatus())
        raise LinearProgramFailed(
            f"HiGHS ended with {status!r} on a program of {m} rows "
            f"and {n} columns; scale the input, whose numbers may be too far apart"
        )
    return np.array(solver.getSolution().col_value)


class Solution(NamedTuple):
    """A minimiser, and what its rows cost.

    Attributes
    ----------
    values : (n,)
    prices : (m,)
        By how much the least cost rises for each unit by which a row's bounds rise.
    """

    values: NDArray[np.float64]
    prices: NDArray[np.float64]


class Program:
    """A linear program that gains rows, and is then solved again from where it was.

    Parameters
    ----------
    cost, matrix, rows, columns
        As for `minimise`.

    Examples
    --------
    >>> program = Program([-1.0], np.zeros((0, 1)), rows=(0.0, 0.0), columns=(0.0, 9.0))
    >>> program.add_rows([[2.0], [4.0]], (-np.inf, [6.0, 8.0]))
    >>> solution = program.solve()
    >>> solution.values.tolist(), float(solution.prices[1])
    ([2.0], -0.25)
    """

    def __init__(
        self,
        cost: ArrayLike,
        matrix: ArrayLike,
        rows: tuple[ArrayLike, ArrayLike],
        columns: tuple[ArrayLike, ArrayLike],
    ) -> None:
        self._solver = _solver(presolve=False)  # which would forget where it was
        self._solver.passModel(_model(cost, np.asarray(matrix, dtype=float), rows, columns))

    def add_rows(self, matrix: ArrayLike, rows: tuple[ArrayLike, ArrayLike]) -> None:
        """Add rows (k, n) with their bounds."""
        A = np.asarray(matrix, dtype=float)
        k, n = A.shape
        lower, upper = (np.broadcast_to(b, k).astype(float) for b in rows)
        starts, columns = np.arange(k) * n, np.tile(np.arange(n, dtype=np.int32), k)
        self._solver.addRows(
            k, lower, upper, A.size, starts.astype(np.int32), columns, np.ascontiguousarray(A)
        )

    def solve(self) -> Solution | None:
        """Solve it; None if HiGHS finds no minimiser."""
        solver = self._solver
        solver.run()
        if not _is_solved(solver):
            solver.clearSolver()
            solver.run()
        if not _is_solved(solver):
            return None
        found = solver.getSolution()
        return Solution(np.array(found.col_value), np.array(found.row_dual))


def _solver(presolve: bool) -> Any:
    """Return a silent solver.

    HiGHS 1.16 prints a banner, from C, as callbacks are set, which the constructor of
    `highspy.Highs` does before anything can be told to it. Its base class sets none.
    """
    from highspy._core import _Highs

    solver = _Highs()
    solver.setOptionValue("output_flag", False)
    solver.setOptionValue("threads", 1)  # so that it finds the same minimiser everywhere
    solver.setOptionValue("parallel", "off")
    solver.setOptionValue("primal_feasibility_tolerance", TOLERANCE)
    solver.setOptionValue("dual_feasibility_tolerance", TOLERANCE)
    if not presolve:
        solver.setOptionValue("presolve", "off")
    return solver


def _model(
    cost: ArrayLike,
    A: NDArray[np.float64],
    rows: tuple[ArrayLike, ArrayLike],
    columns: tuple[ArrayLike, ArrayLike],
) -> Any:
    """Return a program as HiGHS takes it."""
    import highspy

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
    return program


def _is_solved(solver: Any) -> bool:
    """Tell whether a solver has found a minimiser."""
    import highspy

    return bool(solver.getModelStatus() == highspy.HighsModelStatus.kOptimal)
