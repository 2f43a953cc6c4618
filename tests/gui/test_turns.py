"""Whose turn it is, played by hand: no clock, no threads."""

from swarmgrasp.gui.turns import ANSWER, CHEAP, PASSED_BY, Job, Turns

PARTS = ["mesh", "losses"]


def windows(count: int) -> Turns:
    turns = Turns()
    for window in range(count):
        turns.join(window)
    return turns


def end(turns: Turns, job: Job | None, cost: float = 0.001, now: float = 0.0) -> None:
    """End a job; its window takes what came of it at once."""
    assert job is not None
    turns.finish(job, cost, now)
    turns.take(job)


def play(turns: Turns, now: float = 0.0, cost: float = 0.001) -> list[tuple[int, str, object]]:
    """Run jobs one at a time until none is left; return them."""
    told = []
    while (job := turns.next(now)) is not None:
        told.append((job.window, job.kind, job.work))
        end(turns, job, cost, now)
    return told


def test_the_newest_ask_of_a_window_wins() -> None:
    """What was asked in between is never computed."""
    turns = windows(1)
    for number in range(5):
        turns.ask(0, number, False, PARTS)
    assert play(turns) == [(0, ANSWER, 4), (0, "mesh", 4), (0, "losses", 4)]
    assert turns.finished() == [(0, 4)]
    assert turns.finished() == []


def test_answers_of_all_come_before_any_part() -> None:
    """With twenty windows in a gesture no answer waits for another's picture."""
    turns = windows(20)
    for window in range(20):
        turns.ask(window, "ask", True, PARTS)
    told = play(turns)
    assert [kind for _, kind, _ in told[:20]] == [ANSWER] * 20
    assert {window for window, _, _ in told[:20]} == set(range(20))
    assert len(told) == 60


def test_places_are_kept_for_answers_and_errands_while_parts_run() -> None:
    """A long part of one window keeps another neither from its answer nor from opening a scene."""
    turns = windows(2)
    turns.ask(0, "ask", False, PARTS)
    end(turns, turns.next(0.0))
    part = turns.next(0.0)
    assert (part.kind, turns.next(0.0)) == ("mesh", None)
    turns.ask(1, "ask", False, PARTS)
    turns.errand(1, "Open", "a scene")
    job, errand = turns.next(0.0), turns.next(0.0)
    assert (job.window, job.kind) == (1, ANSWER)
    assert (errand.window, errand.kind) == (1, "Open")
    assert turns.next(0.0) is None


def test_a_finer_part_that_is_cheap_takes_the_place_of_the_coarse_one() -> None:
    """At rest, once it is known what the finer one takes; one that was dear comes last."""
    turns = Turns(finer={"rose": "rose, fine"})
    turns.join(0)
    for number, cost, kinds in (
        (1, 0.001, ["rose", "losses", "rose, fine"]),
        (2, 2 * CHEAP, ["rose, fine", "losses"]),
        (3, 0.001, ["rose", "losses", "rose, fine"]),
    ):
        turns.ask(0, number, False, ["rose", "losses", "rose, fine"])
        assert [kind for _, kind, _ in play(turns, cost=cost)] == [ANSWER, *kinds]
    turns.ask(0, 4, False, ["rose"])
    assert [kind for _, kind, _ in play(turns)] == [ANSWER, "rose"]


def test_a_gesture_leaves_out_what_is_dear() -> None:
    """A part that took long, or would take more than a quarter of the time, is left out."""
    turns = windows(1)
    turns.ask(0, 1, True, PARTS)
    play(turns, now=0.0, cost=2.0 * CHEAP)
    turns.ask(0, 2, True, PARTS)
    assert play(turns, now=9.0) == [(0, ANSWER, 2)]
    assert turns.finished() == [(0, 2)]
    turns.ask(0, 3, False, PARTS)
    assert len(play(turns, now=10.0, cost=0.5 * CHEAP)) == 3
    turns.ask(0, 4, True, PARTS)
    assert play(turns, now=10.0 + CHEAP) == [(0, ANSWER, 4)]
    turns.ask(0, 5, True, PARTS)
    assert len(play(turns, now=10.0 + 3.0 * CHEAP)) == 3


def test_a_window_at_rest_is_not_passed_by_for_ever() -> None:
    """Where others always ask, its parts come all the same after so many answers."""
    turns = windows(2)
    turns.ask(0, "rest", False, PARTS)
    end(turns, turns.next(0.0))
    answers = 0
    while True:
        turns.ask(1, "moving", True, [])
        job = turns.next(0.0)
        turns.ask(1, "next", True, [])
        part = turns.next(0.0)
        end(turns, job)
        if part is not None:
            break
        answers += 1
    assert (part.window, part.kind) == (0, "mesh")
    assert answers == PASSED_BY - 1


def test_a_window_that_does_not_read_keeps_nobody_waiting() -> None:
    """It has no other turn, and its next ask is not owed, before it has taken the last answer."""
    turns = windows(2)
    turns.ask(0, 1, True, PARTS)
    slow = turns.next(0.0)
    assert slow is not None
    turns.finish(slow, 0.001, 0.0)
    turns.ask(0, 2, True, PARTS)
    turns.ask(1, 1, True, PARTS)
    assert play(turns) == [(1, ANSWER, 1), (1, "mesh", 1), (1, "losses", 1)]
    assert turns.finished() == [(1, 1)]
    turns.take(slow)
    assert [kind for _, kind, _ in play(turns)] == [ANSWER, *PARTS]


def test_a_new_ask_ends_the_parts_of_the_last() -> None:
    """What is being computed is told that it has been overtaken."""
    turns = windows(1)
    turns.ask(0, 1, False, PARTS)
    end(turns, turns.next(0.0))
    turns.next(0.0)
    assert not turns.is_overtaken(0, 1)
    turns.ask(0, 2, False, [])
    assert turns.is_overtaken(0, 1)


def test_a_window_that_has_gone_leaves_nothing() -> None:
    """Its jobs end, and no others begin."""
    turns = windows(1)
    turns.ask(0, 1, False, PARTS)
    job = turns.next(0.0)
    turns.leave(0)
    turns.finish(job, 0.001, 0.0)
    assert turns.next(0.0) is None
    assert turns.is_overtaken(0, 1)
