"""Faults that Hypothesis thinks of, rather than those that a seed draws.

Lists serve: a state machine that struck robots at their words found fewer of the mutants.
"""

import math

from hypothesis import given, settings
from hypothesis import strategies as st

from simulated import run
from swarmgrasp.agents.simulator import Fault, Mode, Schedule, What

NAMES = ("R1", "R2", "R3")
TIMES = st.floats(0.0, 11.0).map(lambda time: round(time, 1))
PAIRS = st.permutations(NAMES).map(lambda names: tuple(names[:2]))
LASTING = st.sampled_from([What.HANG, What.CRASH, What.FORGET, What.CUT, What.DEAF, What.SPLIT])
MOMENTS = st.sampled_from([What.JOIN, What.LEAVE, What.MOVE, What.FALL, What.JUMP])


@st.composite
def faults(draw):
    """Draw a fault of three robots."""
    at = draw(TIMES)
    if draw(st.booleans()):
        return Fault(draw(MOMENTS), at, math.inf, (draw(st.sampled_from(NAMES)),))
    what, names = draw(LASTING), draw(PAIRS)
    names = names if what in {What.CUT, What.DEAF} else names[:1]
    return Fault(what, at, round(at + draw(st.floats(0.1, 9.0)), 1), names)


@settings(max_examples=40, deadline=None)
@given(st.lists(faults(), max_size=8), st.integers(0, 50), st.sampled_from([0.0, 0.3]))
def test_all_invariants_hold_whatever_happens_to_three(happening, seed, loss):
    """Three join; then any faults, at any times."""
    joins = tuple(Fault(What.JOIN, 0.5 * k, names=(name,)) for k, name in enumerate(NAMES))
    mode = Mode.ROSTER if seed % 3 == 0 else Mode.MAIN
    outcome = run(Schedule(mode, seed, (*joins, *happening), loss=loss, calm=12.0))
    assert outcome.broken is None, str(outcome.broken)
