"""What the paper prints: its two examples, its fitted times, and its misprints."""

from typing import NamedTuple


class Example(NamedTuple):
    """An example of the paper's: so many robots on a rectangle, and one more.

    Attributes
    ----------
    figure : str
    robots : int
        Before the newcomer; all pull along the outward normal.
    before, after : float [N]
        Qualities, of robots of 1 N.
    seconds : float [s]
        What Algorithm 1 took.
    """

    figure: str
    robots: int
    before: float
    after: float
    seconds: float


EXAMPLES = (Example("Fig. 4", 5, 0.0, 0.39, 0.816), Example("Fig. 5", 15, 2.26, 2.67, 2.72))

TIME_FITS = {"best": 0.0059, "median": 0.0104, "worst": 0.1841}
"""C in the fitted time C N^2 [s] of Fig. 6, over 10 configurations for each N."""

ROBOTS_TIMED = (5, 25)
"""Least and most robots of Fig. 6."""

MACHINE = "MATLAB R2006a on a Pentium 4"
