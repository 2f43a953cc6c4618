"""Each rule taken away breaks a schedule: none is for show, and the checks see it."""

import pytest

from every_order import Search
from simulated import drawn, run
from swarmgrasp.agents.protocol import Agent, Phase, decisions
from swarmgrasp.agents.protocol import agent as agent_module
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.confirming import Confirmations
from swarmgrasp.agents.protocol.hearing import Hearing
from swarmgrasp.agents.protocol.state import State
from swarmgrasp.agents.protocol.wire import Ack
from swarmgrasp.agents.simulator import Mode, Schedule, read_faults


def no_confirmation(patch):
    """Fasten without asking (R6)."""
    patch.setattr(Confirmations, "needed", ())


def confirmation_without_record(patch):
    """Count a confirmation without what the confirmer says of itself (R5)."""
    received = Agent._received

    def deaf(self, event):
        if isinstance(event.message, Ack) and event.message.of == self.record.asks_for:
            self._confirmations.take(event.sender)
            self._hear(event.sender)
        else:
            received(self, event)

    patch.setitem(agent_module._HANDLERS, ev.Received, deaf)


def no_listening(patch):
    """Fasten as soon as the process begins (R6)."""
    patch.setattr(Hearing, "has_listened", True)


def no_gap_rule(patch):
    """Take one's own deafness for others' silence (R7)."""

    def advance(self, clock):
        if self._last is None:
            self._lost = clock
        self._last, self.now = clock, clock - self._lost
        return False

    patch.setattr(Hearing, "advance", advance)


def later_does_not_yield(patch):
    """Of two that have arrived at one place neither gives way (R4)."""
    conflicts_of = decisions.conflicts_of

    def only_fixed(me, view, planner):
        return [other for other in conflicts_of(me, view, planner) if other.is_fixed]

    patch.setattr(decisions, "conflicts_of", only_fixed)


def no_fastening(patch):
    """Look merely arrived until attached: give way to an earlier ticket while touching (R4)."""
    commit, done = Agent._commit, set()

    def quiet(self):
        if (self.name, self.record.asks_for) not in done:
            commit(self)
        if self._word.now.phase is Phase.FASTENING:
            done.add((self.name, self.record.asks_for))
            self._word.change(phase=Phase.ARRIVED)

    patch.setattr(Agent, "_commit", quiet)


def memory_forgotten(patch):
    """Keep one's own record alone from one life to the next, and not whom one has confirmed."""
    state = property(lambda self: State(self._knowledge.clock, (self.record,), ()))
    patch.setattr(Agent, "state", state)


def no_anti_entropy(patch):
    """Never ask for what was lost."""
    patch.setattr(Agent, "_beat", lambda *_: None)


def no_refutation(patch):
    """Let the word of a former life stand (R11)."""
    patch.setattr(Agent, "_refute", lambda *_: None)


def no_order_of_moves(patch):
    """Confirm another's move while letting go oneself (R10)."""
    put = Agent._put

    def careless(self, record, is_direct):
        lets_go, self._decisions.may_loosen = self._decisions.may_loosen, False
        put(self, record, is_direct)
        self._decisions.may_loosen = lets_go

    patch.setattr(Agent, "_put", careless)


def of_text(mode, seed, text, calm, **more):
    """Return a schedule."""
    return Schedule(mode, seed, read_faults(text), calm=calm, **more)


MUTANTS = {
    no_confirmation: of_text(
        Mode.RESOLVE, 1,
        "start@0:R3; start@0:R4; start@0:R5; join@1:R1; join@2.2:R3; split@2.2-15:R2,R3; "
        "join@2.4:R5",
        15.4,
    ),
    no_listening: of_text(
        Mode.MAIN, 2,
        "hang@1.38-2.07:R2; split@6.08-13.6:R8; join@9.86:R7; join@10.39:R8; join@11.64:R6",
        15.0, loss=0.35, delay=0.842,
    ),
    no_gap_rule: of_text(
        Mode.HANGS, 133,
        "join@0:R6; join@0.19:R3; join@0.2:R4; hang@0.36-6.11:R6; join@1:R1; hang@1.59-6.7:R6; "
        "hang@1.74-4.87:R4; hang@2-7:R2; hang@3-10:R3; hang@6.55-13.47:R4; hang@7.8-12:R1; "
        "hang@16.12-19.3:R5",
        19.3, loss=0.29, delay=0.391,
    ),
    later_does_not_yield: drawn(Mode.MAIN, 139),
    no_fastening: of_text(
        Mode.MAIN, 2547,
        "start@0:R1; start@0:R2; split@2-10.5:R1; join@5:R1; join@5.5:R2", 11.5,
    ),
    memory_forgotten: of_text(
        Mode.MAIN, 1,
        "join@0:R1; start@0:R2; split@14-40:R2; crash@15-16:R2; join@17:R2", 40.0,
    ),
    no_anti_entropy: drawn(Mode.MAIN, 1),
    no_refutation: drawn(Mode.MAIN, 1),
    no_order_of_moves: of_text(
        Mode.MOVES, 3, "start@0:A4; join@1:R1; move@30:R1; move@30.5:A4", 31.0
    ),
}  # fmt: skip
"""A schedule that each mutant breaks."""


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.__name__)
def test_a_rule_that_is_taken_away_is_missed(mutant, monkeypatch):
    """The schedule holds with the rule, and breaks without."""
    assert run(MUTANTS[mutant]).broken is None
    mutant(monkeypatch)
    assert run(MUTANTS[mutant]).broken is not None


@pytest.mark.parametrize(
    "mutant", [no_confirmation, confirmation_without_record, later_does_not_yield]
)
def test_a_rule_of_arrival_that_is_taken_away_is_missed_in_some_order(mutant, monkeypatch):
    """The search of all orders finds one in which two are at one spot."""
    mutant(monkeypatch)
    with pytest.raises(AssertionError, match="two at one spot"):
        Search(2, 2).run()
