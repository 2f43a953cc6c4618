"""The page on what robots must tell each other: sections, sentences and their checks."""

from collections.abc import Callable
from contextlib import nullcontext
from itertools import pairwise
from pathlib import Path

from swarmgrasp.agents.knowledge import FULL, Curve, Lines, Size, measure, tasks_of
from swarmgrasp.agents.knowledge.beliefs import (
    BINS,
    EVEN,
    LOST,
    NEAREST,
    NOTHING,
    RANDOM,
    SIGHT,
    WORST,
    lost,
    nearest,
    summary_of,
)
from swarmgrasp.agents.knowledge.cases import FREE, NEWCOMERS, PUSH, STEER
from swarmgrasp.pages.page import Block, Findings, Heading, Paragraph, Picture, Table
from swarmgrasp.pages.runner import Runner, workers
from swarmgrasp.pages.statements import Statement, listed, newtons, spaced
from swarmgrasp.pages.writing import Report, write
from swarmgrasp.plot.curve import knowledge_curve

NAME = "communication"
"""Of the page's files."""
TITLE = "What robots must tell each other"
OFF_NORMAL, STEERED = NEWCOMERS[PUSH].half_angle, NEWCOMERS[STEER].half_angle
"""How far off the normal robots of the study push, and steer [rad]."""
SMALL_LOSS = 0.03
"""Of the quality, that counts as none."""
PICTURE = 4
"""The picture takes about as long as so many draws."""
BY_CASE = (summary_of(BINS[1]), lost(10), lost(50), nearest(4), SIGHT, NOTHING, EVEN, RANDOM)
"""What the table of the single cases has."""


def curve_steps(size: Size) -> int:
    """Return how far a progress bar goes."""
    return len(tasks_of(size, 0)) + PICTURE


def write_curve(
    folder: str | Path,
    size: Size = FULL,
    seed: int = 1,
    *,
    progress: Callable[[int], object] | None = None,
    in_processes: bool = True,
) -> tuple[Report, Curve]:
    """Measure final quality against what is communicated, and write a page on it.

    Parameters
    ----------
    folder : str or Path
        Created if need be. Files of an earlier page in it are replaced; all appear at the end, or
        none.
    size : Size
        How much to measure.
    seed : int
        Of the random draws, at least 0.
    progress : callable, optional
        Called with a number that goes up to `curve_steps`.
    in_processes : bool
        Measure in processes of their own, one for each core; otherwise in this one. A script that
        asks for them should do so under ``if __name__ == "__main__":``.

    Returns
    -------
    Report, Curve

    Raises
    ------
    OSError
        If the folder cannot be written to.
    """
    with workers() if in_processes else nullcontext() as executor:
        runner = Runner(executor, progress)
        curve = measure(size, seed, runner.map)
    said = statements(curve)
    every = [one for group in said.values() for one in group]
    blocks = sections(curve, said)
    report = write(Path(folder), NAME, TITLE, blocks, every, lambda: runner.advance(PICTURE))
    return report, curve


def statements(curve: Curve) -> dict[str, list[Statement]]:
    """Return what the curve says, by question; each checked on it."""
    return {
        "Is communication needed?": _needed(curve),
        "How much does it help?": _helps(curve),
        "What does planning for the worst cost?": _worst(curve),
        "What is certain, whatever one does not know?": _certain(curve),
    }


def _needed(curve: Curve) -> list[Statement]:
    """State what is reached without a word."""
    every, seen = curve.every, [curve.kind(kind)[SIGHT].median for kind in (STEER, PUSH, FREE)]
    return [
        Statement(
            "To hold the object, no; to hold it well, yes. Newcomers that know nothing of the "
            f"others but which places are taken end at {_share(every, NOTHING)} of the quality "
            "that is reached with everything known, and at random places at "
            f"{_share(every, RANDOM)}.",
            0.0 < every[NOTHING].median < 1.0 - SMALL_LOSS
            and every[RANDOM].median < 1.0 - SMALL_LOSS,
        ),
        Statement(
            "What sight is worth hangs on how much a place tells of the force: with places seen "
            f"and directions taken along the normals, robots that steer end at {_percent(seen[0])} "
            f"at the median, robots that push within {OFF_NORMAL} rad of the normal at "
            f"{_percent(seen[1])}, robots that push in any direction at {_percent(seen[2])}.",
            seen[0] > seen[1] > seen[2],
        ),
    ]


def _helps(curve: Curve) -> list[Statement]:
    """State what some words are worth."""
    every = curve.every
    lost_medians = [1.0, *(every[lost(share)].median for share in LOST)]
    others = [line for line in every.lines if line.known != EVEN]
    return [
        Statement(
            f"Telling everything makes the quality {1.0 / every[NOTHING].median:.1f} times what it "
            "is without a word, at the median.",
            every[NOTHING].median < 1.0 - SMALL_LOSS,
        ),
        Statement(
            "Summaries lose nothing: with "
            f"{listed(BINS)} bins swarms end at "
            f"{listed([_percent(every[summary_of(bins)].median) for bins in BINS])} at the median. "
            "They are the right thing above a size.",
            all(abs(every[summary_of(bins)].median - 1.0) < SMALL_LOSS for bins in BINS[:2]),
        ),
        Statement(
            "A record that is never heard costs, the more the more are: with each lost by "
            f"{listed([f'{share} %' for share in LOST])} swarms end at "
            f"{listed([_percent(m) for m in lost_medians[1:]])}. Messages that are repeated until "
            "they are heard cost time only.",
            all(a > b for a, b in pairwise(lost_medians)),
        ),
        _neighbours(curve),
        Statement(
            "To take those not heard for evenly spread is the worst of all beliefs (T33): swarms "
            f"end at {_share(every, EVEN)}. A swarm believed to be balanced is helped by no place, "
            "so the choice is blind.",
            all(every[EVEN].median < line.median for line in others),
        ),
    ]


def _neighbours(curve: Curve) -> Statement:
    """State what comes of knowing those nearest only."""
    push = curve.kind(PUSH)
    near = {count: curve.every[nearest(count)].median for count in NEAREST}
    return Statement(
        "Neighbours alone do not do, the less the fewer: with the "
        f"{listed(list(near))} nearest swarms end at "
        f"{listed([_percent(m) for m in near.values()])}. Each counters its neighbours, and "
        f"all do so: robots that push within {OFF_NORMAL} rad of the normal end lower with the "
        f"2 nearest ({_percent(push[nearest(2)].median)}) than with nobody "
        f"({_percent(push[NOTHING].median)}) or at random places "
        f"({_percent(push[RANDOM].median)}).",
        all(a > b for a, b in pairwise(near.values()))
        and push[nearest(2)].median < min(push[NOTHING].median, push[RANDOM].median),
    )


def _worst(curve: Curve) -> list[Statement]:
    """State what caution costs."""
    push = curve.kind(PUSH)
    return [
        Statement(
            "It is too cautious where directions may be off by much. Robots that push within "
            f"{OFF_NORMAL} rad of the normal, planned by sight alone for the worst of all "
            f"directions that the others may push in, end at {_share(push, WORST)}; with the "
            f"directions simply taken along the normals at {_share(push, SIGHT)}.",
            push[WORST].median < push[SIGHT].median,
        ),
    ]


def _certain(curve: Curve) -> list[Statement]:
    """State what the theory says of every decision."""
    judged = [line for line in curve.every.lines if line.decisions]
    decisions, broken = (
        sum(getattr(line, name) for line in judged) for name in ("decisions", "broken")
    )
    regret, bound = (
        sum(getattr(line, name) * line.decisions for line in judged) / decisions
        for name in ("regret", "bound")
    )
    fine = curve.every[summary_of(BINS[0])]
    return [
        Statement(
            f"What a newcomer does not know, e = h - h^, costs it at most max e - min e (T30): of "
            f"{spaced(decisions)} decisions {'none' if not broken else spaced(broken)} fell short "
            "of the best place by more. Both extremes are bounds over all directions, at most 5 % "
            "of their difference, or 0.01 N, apart from what e attains.",
            broken == 0,
        ),
        Statement(
            f"The bound is safe, not sharp: decisions fell short by {newtons(regret)} in the mean, "
            f"and might have by {newtons(bound)}; from a summary of {BINS[0]} bins by "
            f"{newtons(fine.regret, 4)} and {newtons(fine.bound)}.",
            regret < bound and fine.regret < fine.bound < bound,
        ),
    ]


def sections(curve: Curve, said: dict[str, list[Statement]]) -> list[Block]:
    """Return the whole page."""
    every = [one for group in said.values() for one in group]
    failed = sum(not one.holds for one in every)
    verdict = "all hold" if not failed else f"{failed} of them, marked ✗, do not hold in it"
    less = ""
    if curve.size != FULL.name:
        less = (
            f" This is a {curve.size} run: few swarms, so the shares are rough. The full one takes "
            "some minutes."
        )
    blocks: list[Block] = [
        Heading(TITLE, 1),
        Paragraph(
            "J. M. Esposito's paper lets robots of a swarm attach one after the other, each where "
            "the quality of the grasp becomes best, and asks at its end whether they have to "
            "communicate, how much that helps, and what planning for the worst costs. Here swarms "
            "grow on several objects, from several kinds of robots, to several sizes; each "
            "newcomer sees which places are taken, and knows of the robots there what the line "
            "says. In the end the true quality of all is compared with that of the same swarm "
            "grown with everything known."
        ),
        Paragraph(
            f"{len(every)} statements below were checked in this run (swarmgrasp agents curve, "
            f"seed {curve.seed}): {verdict}.{less}"
        ),
        Picture(
            f"{NAME}.png",
            knowledge_curve(curve),
            "Left: final quality over that with everything known. Right: how far one decision "
            "falls short of the best place in the mean, and how far it may at most.",
        ),
    ]
    for question, group in said.items():
        blocks += [Heading(question), Findings(group)]
    return [*blocks, *_tables(curve), *_method(curve)]


def _tables(curve: Curve) -> list[Block]:
    """Return the numbers."""
    rows = [
        [
            line.known, str(line.draws), f"{line.median:.2f}", f"{line.low:.2f}-{line.high:.2f}",
            *([f"{line.regret:.3f}", f"{line.bound:.2f}"] if line.decisions else ["-", "-"]),
        ]
        for line in curve.every.lines
    ]  # fmt: skip
    heads = ["what a newcomer knows", "swarms", "median", "10-90 %", "short [N]", "at most [N]"]
    names = [name for name in BY_CASE if name in curve.every]
    cases = [
        [lines.of, newtons(lines.quality),
         *(f"{lines[name].median:.2f}" if name in lines else "-" for name in names)]
        for lines in curve.cases
    ]  # fmt: skip
    return [
        Heading("The numbers"),
        Paragraph(
            "The final quality over that with everything known; then how far one decision fell "
            "short of the best place, and what T30 allows, in the mean. A dash: there is no "
            "support function that the decision rests on, or the question makes no sense."
        ),
        Table(heads, rows),
        Heading("Case by case", 3),
        Paragraph("The quality with everything known, and the medians of the shares."),
        Table(["case", "quality", *names], cases),
    ]


def _method(curve: Curve) -> list[Block]:
    """Say what was done."""
    return [
        Heading("How it was measured"),
        Paragraph(
            "Objects: a barge of 80 m by 20 m, a ship hull of 120 m by 20 m, a round tank of 24 m "
            f"across. Robots of 1 N: push, along one direction within {OFF_NORMAL} rad of the "
            f"inward normal; free, along any one direction; steer, at all times within {STEERED} "
            "rad of the normal. The first 3, 6 or 12 robots stand at random places, the others, up "
            "to 8, 20 or 40, come one after the other and stay. The spacing is the perimeter over "
            "three times their number."
        ),
        Paragraph(
            "Lost: each newcomer misses each record with that probability, for good. Nearest: "
            "around the object from where it comes to it. For the worst: the quality in the worst "
            f"of all directions within {OFF_NORMAL} rad of the normals. Evenly spread: as many "
            "robots at equal distances, along the normals. Robots that steer are left out where "
            "summaries are told, beside which places are known how to find of robots that push "
            "along one direction, and of planning for the worst: what they can do is seen."
        ),
        Paragraph(
            f"Seed {curve.seed}; the same seed gives the same numbers. Metric: torques over the "
            "largest distance from the centroid to the outline."
        ),
    ]


def _share(lines: Lines, known: str) -> str:
    """Write the median of a knowledge, and its range."""
    line = lines[known]
    return f"{_percent(line.median)} ({_percent(line.low)} to {_percent(line.high)})"


def _percent(share: float) -> str:
    """Write a share that may be above 1, in whole percent.

    Examples
    --------
    >>> _percent(1.0049), _percent(0.127)
    ('100 %', '13 %')
    """
    return f"{100.0 * share:.0f} %"
