"""The sections of the report: what is said, tabled and drawn."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import date

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.pages.page import Block, Findings, Heading, Labelled, Paragraph, Picture, Table
from swarmgrasp.pages.statements import largest, median, newtons, percent, seconds
from swarmgrasp.paper import pictures
from swarmgrasp.paper.draws import BREADTH, FREE, LENGTH, NEWCOMERS, NORMAL, pulling, rectangle
from swarmgrasp.paper.machine import machine
from swarmgrasp.paper.measured import Measured
from swarmgrasp.paper.published import EXAMPLES, MACHINE, ROBOTS_TIMED, TIME_FITS, Example
from swarmgrasp.paper.studies.misprints import ERRATA
from swarmgrasp.paper.studies.misprints import ROBOTS as MISPRINTED
from swarmgrasp.paper.studies.misprints import statements as misprint_statements
from swarmgrasp.paper.studies.relaxation import COUNTS
from swarmgrasp.paper.studies.speed import Speeds, objective_cost
from swarmgrasp.paper.theory import THEORY
from swarmgrasp.placement import place
from swarmgrasp.plot import plan, wrench_sets

TITLE = "Distributed grasp synthesis, made again"
PICTURES = 11
"""How many pictures there are."""


def sections(found: Measured) -> list[Block]:
    """Return the whole report."""
    parts: Sequence[Callable[[Measured], list[Block]]] = (
        _opening, _published, _construction, _examples, _speed, _cross_section, _relaxation,
        _plateaus, _misprints, _theory, _method,
    )  # fmt: skip
    return [block for part in parts for block in part(found)]


def _opening(found: Measured) -> list[Block]:
    """Say what this is, and whether it all holds."""
    every = found.every
    failed = sum(not one.holds for one in every)
    verdict = f"All {len(every)} statements below were checked in this run, and hold."
    if failed:
        verdict = (
            f"{len(every)} statements below were checked in this run; {failed} of them, marked ✗, "
            "do not hold in it."
        )
    less = ""
    if found.size.name != "full":
        less = (
            f" This is a {found.size.name} run: few draws, so the shares are rough. The full one "
            "takes a few minutes."
        )
    return [
        Heading(TITLE, 1),
        Paragraph(
            "J. M. Esposito, Distributed Grasp Synthesis for Swarm Manipulation with Applications "
            "to Autonomous Tugboats, ICRA 2008, tells where the next robot of a swarm should "
            "attach, and which way it should push. This report follows the paper figure by figure: "
            "what it prints, what it should have printed, and what is true."
        ),
        Paragraph(
            f"{verdict} Every number is measured by this run (swarmgrasp paper, seed {found.seed}) "
            f"or printed in the paper.{less}"
        ),
        Paragraph(_in_short(found)),
        Paragraph(
            "The paper's configurations are in its figures only. Here they are drawn at random: "
            f"robots of 1 N anywhere on a rectangle of {LENGTH:g} m by {BREADTH:g} m, which pull "
            "along the outward normal as the paper's do. Torques are divided by "
            f"{rectangle().radius:.3f} m, the distance of a corner from the middle. Sides and "
            "metric are a choice made here, so single numbers can only agree in kind. A newcomer "
            "has 1 N too, and acts either along the outward normal or in any "
            "direction, as a free robot can. Quality is the radius of the largest ball of wrenches "
            "that the robots can exert: with 0 they do not hold the object."
        ),
    ]


def _in_short(found: Measured) -> str:
    """Return the findings in a paragraph."""
    free = [kinds[FREE] for kinds in found.relaxations.values()]
    unreal, missed, worse = (
        percent(float(np.mean(np.concatenate(column))))
        for column in zip(*((one.unreal, one.missed, one.worse) for one in free), strict=True)
    )
    stuck = np.concatenate([~one.helps[FREE] for one in found.gains.values()])
    faster = float(np.median(found.speeds.theirs / found.speeds.ours))
    return (
        "In short: the idea stands, a level of quality is reached on a convex set of wrenches. But "
        f"that set is not what robots can do: on {unreal} of all draws no robot attains the "
        f"optimum that Algorithm 1 looks for, on {missed} its local solver misses that optimum, "
        f"and on {worse} it ends with a robot that is worse than the best. The best robot, with a "
        f"proof, takes 1/{faster:.0f} of the time. And on {percent(float(np.mean(stuck)))} of the "
        "draws no single robot helps, wherever it goes."
    )


def _published(found: Measured) -> list[Block]:
    """Put the paper's figures beside ours."""
    rows = []
    for example in EXAMPLES:
        gains = found.gains[example.robots]
        k = gains.shown(example)
        here = f"{newtons(gains.before[k])} → {newtons(gains.after[NORMAL][k])}"
        printed = f"{newtons(example.before)} → {newtons(example.after)}"
        what = f"{example.figure}: robot {example.robots + 1}"
        rows.append([f"{what}, quality", printed, here, "the nearest draw"])
        row = int(np.abs(found.speeds.robots - example.robots).argmin())
        ours, theirs = (np.median(t[row]) for t in (found.speeds.ours, found.speeds.theirs))
        time = f"Algorithm 1 {seconds(theirs)}, certified optimum {seconds(ours)}"
        rows.append([f"{what}, time", seconds(example.seconds), time, "median of the draws"])
    ours, theirs = (found.speeds.quadratic(t) for t in (found.speeds.ours, found.speeds.theirs))
    for name, fitted in TIME_FITS.items():
        here = f"Algorithm 1 {seconds(theirs[name])}, certified optimum {seconds(ours[name])}"
        rows.append([f"Fig. 6: C in C N², {name}", f"{fitted} s", here, "least squares"])
    heads = ["what", f"the paper ({MACHINE})", "here", "as"]
    return [Heading("The paper's numbers beside ours"), Table(heads, rows, numbers=())]


def _construction(found: Measured) -> list[Block]:
    """Fig. 2: the wrench set."""
    return [
        Heading("Fig. 2: how the wrench set is built"),
        Paragraph(
            "Each robot can exert any force from 0 to its limit, in one direction: its wrenches "
            "are a segment from the origin. All robots together can exert the sums, one wrench "
            "from each segment. A newcomer moves the set along its own segment."
        ),
        Picture(
            "paper-fig-2.png",
            pictures.construction(found.steps),
            "Wrench sets of one to six robots, to one scale. Red: the segment of the last robot; "
            "dark: the set before it; cross: the origin; blue: the largest ball about it.",
        ),
        Findings(found.statements["construction"]),
    ]


def _examples(found: Measured) -> list[Block]:
    """Fig. 4 and Fig. 5: the next robot on a rectangle."""
    return [block for example in EXAMPLES for block in _example(found, example)]


def _example(found: Measured, example: Example) -> list[Block]:
    """One of them."""
    gains, name = found.gains[example.robots], example.figure.lower().replace(". ", "-")
    swarm = pulling(gains.draws[gains.shown(example)])
    answer = place(swarm, NEWCOMERS[NORMAL])
    count = f"{example.robots} + 1 robots"
    return [
        Heading(f"{example.figure}: {count} on a rectangle"),
        Picture(
            f"paper-{name}-draws.png",
            pictures.gains(gains, example),
            f"What the best newcomer brings, over {len(gains.before)} random draws of "
            f"{example.robots} robots, with the paper's example.",
        ),
        Findings(found.statements[example.figure]),
        Picture(
            f"paper-{name}-plan.png",
            plan(swarm, placements=[answer]),
            f"The draw nearest to the paper's: {count}, each pulling along the outward normal.",
        ),
        Picture(
            f"paper-{name}-wrenches.png",
            wrench_sets(swarm, answer.swarm_after),
            "What its robots can exert, before (gray) and after (wire frame).",
        ),
    ]


def _speed(found: Measured) -> list[Block]:
    """Fig. 6: computing time."""
    low, high = ROBOTS_TIMED
    heads = ["robots", *(f"{who}, {name}" for who in ("paper", "Algorithm 1", "certified")
                         for name in TIME_FITS)]  # fmt: skip
    shown = [n for n in found.speeds.robots if n % 5 == 0]
    rows = [
        *(_times(found.speeds, int(n), [c * n**2 for c in TIME_FITS.values()]) for n in shown),
        *(_times(found.beyond, int(n), []) for n in found.beyond.robots),
    ]
    return [
        Heading("Fig. 6: computing time"),
        Paragraph(
            f"{found.size.configurations} random configurations for each number of robots, a "
            f"newcomer free in its direction. The paper fits C N² to its times from {low} to "
            f"{high} robots ({MACHINE}). Here both methods ran one after the other on "
            f"{machine()}, each on one core. Algorithm 1 solves each query by SciPy's SLSQP with "
            "analytic derivatives; the certified optimum includes its proof."
        ),
        Picture(
            "paper-fig-6.png",
            pictures.speed(found.speeds, found.beyond),
            "Time of one placement: median as a line, best to worst as a band.",
        ),
        Findings(found.statements["speed"]),
        Table(heads, rows),
    ]


def _times(speeds: Speeds, robots: int, printed: list[float]) -> list[str]:
    """Return a row of the table of times."""
    k = int(np.flatnonzero(speeds.robots == robots)[0])
    cells = [seconds(value) for value in printed] or ["-"] * len(TIME_FITS)
    for times in (speeds.theirs[k], speeds.ours[k]):
        cells += [seconds(v) for v in (times.min(), np.median(times), times.max())]
    return [str(robots), *cells]


def _cross_section(found: Measured) -> list[Block]:
    """Fig. 8 and Fig. 9: why the sets above a level are convex."""
    return [
        Heading("Fig. 8 and Fig. 9: why a level is reached on a convex set"),
        Paragraph(
            "The paper's appendix argues with cross-sections. Three lines do. With a new wrench b "
            "the quality is Q(b) = min over all directions n of h(n) + max(0, n · b), where h(n) "
            "is how far the robots that are there reach along n. For a fixed n the bracket does "
            "not fall with the linear n · b, so the b for which it reaches a level are a half "
            "space, or everything. The b for which all of them do are an intersection of half "
            "spaces, which is convex."
        ),
        Picture(
            "paper-fig-8-9.png",
            pictures.cross_section(found.section),
            "Left: brackets along a line of wrenches, and their least. Right: the quality over a "
            "plane through that line; red: where it reaches the same level.",
        ),
        Findings(found.statements["cross-section"]),
    ]


def _relaxation(found: Measured) -> list[Block]:
    """Show what the paper did not look at: first its relaxation."""
    heads = [
        "robots", "newcomer", "optimum out of reach", "gain promised in vain: median", "worst",
        "solver misses it", "attached robot worse", "gain lost: median", "worst",
    ]  # fmt: skip
    rows = []
    for robots, kinds in found.relaxations.items():
        for kind, one in kinds.items():
            vain, lost = one.phantom[one.unreal], one.lost[one.worse]
            rows.append([
                str(robots), kind, _share(one.unreal), percent(median(vain)),
                percent(largest(vain)), _share(one.missed), _share(one.worse),
                percent(median(lost)), percent(largest(lost)),
            ])  # fmt: skip
    return [
        Heading("What the paper did not look at"),
        Paragraph(
            "Algorithm 1 looks for the best wrench in a cylinder, |F| ≤ limit and |tau| ≤ limit "
            "r_max, by a local solver, and then attaches the robot whose wrench is nearest. But a "
            "robot's torque is tied to its force: tau = c x F. Below, the optimum over the "
            "cylinder is found by cutting planes and the best robot by our search, each with an "
            "upper bound at most 1e-6 above it, so that three things can be told apart: what the "
            "cylinder promises in vain, what the local solver misses, and what the attachment "
            f"loses. A difference counts from {newtons(COUNTS, 3)} on, ten times Algorithm 1's "
            "epsilon."
        ),
        Findings(found.statements["relaxation"]),
        Picture(
            "paper-relaxation.png",
            pictures.relaxation(found.relaxations),
            "Left: the share of the gain in the cylinder that no robot can deliver. Right: the "
            "share of the best robot's gain that the attached one does not bring. Across: the "
            "share of the draws on which it is at least that much.",
        ),
        Table(heads, rows),
    ]


def _share(mask: NDArray[np.bool_]) -> str:
    """Write the share of draws."""
    return percent(float(np.mean(mask)))


def _plateaus(found: Measured) -> list[Block]:
    """Show what else it did not look at: plateaus, and when one robot is not enough."""
    robots = EXAMPLES[-1].robots
    return [
        Heading("How large the plateaus are"),
        Paragraph(
            "Often many places are equally good, because the weakest direction is one to which "
            "the newcomer's place does not matter. A place counts when it comes within 1e-6 of "
            "the best."
        ),
        Picture(
            "paper-plateau.png",
            pictures.plateau(found.plateaus[robots].widest),
            f"The widest plateau among the draws of {robots} robots: the quality over all contacts "
            "and directions of a newcomer, and where it is the best.",
        ),
        Findings(found.statements["plateaus"]),
        _plateau_table(found),
        Heading("When one robot is not enough"),
        Findings(found.statements["helpless"]),
    ]


def _plateau_table(found: Measured) -> Table:
    """Return the sizes of the plateaus by number of robots."""
    heads = ["robots", "newcomer", "plateau on", "its share: median", "largest"]
    rows = []
    for robots, one in found.plateaus.items():
        for kind in NEWCOMERS:
            shares = one.shares[kind][one.helps[kind]]
            wide = shares[shares > 0.0]
            part = len(wide) / max(len(shares), 1)
            sizes = percent(median(wide)), percent(largest(wide))
            rows.append([str(robots), kind, percent(part), *sizes])
    return Table(heads, rows)


def _misprints(found: Measured) -> list[Block]:
    """List the errata."""
    said = misprint_statements(found.misprints)
    said |= {
        "sets": found.statements["cross-section"][-1],
        "cost": objective_cost(int(found.speeds.robots[-1])),
    }
    rows = [[e.where, e.printed, e.meant] for e in ERRATA.values()]
    follows = [replace(said[key], text=f"{e.where}: {said[key].text}") for key, e in ERRATA.items()]
    return [
        Heading("Misprints, and what comes of them"),
        Paragraph(
            "Each was followed to the letter, one at a time and all others corrected, on "
            f"{found.size.misprints} draws of {MISPRINTED} robots, with a newcomer that may push "
            f"{FREE}."
        ),
        Table(["where", "printed", "meant"], rows, numbers=()),
        Findings(follows),
    ]


def _theory(found: Measured) -> list[Block]:
    """Say what the statements rest on."""
    used = {label for one in found.every for label in one.rests_on}
    return [
        Heading("What it rests on"),
        Paragraph(
            "The labels at the statements lead here. The proofs stand on the page Theory of the "
            "documents, under the same labels."
        ),
        Labelled({label: said for label, said in THEORY.items() if label in used}),
    ]


def _method(found: Measured) -> list[Block]:
    """Say how it was measured."""
    size = found.size
    return [
        Heading("How it was measured"),
        Paragraph(
            f"{date.today()}, on {machine()}. Draws for each of {len(found.gains)} numbers of "
            f"robots: {size.gains} for the gains, {size.relaxed} for the relaxation, "
            f"{size.plateaus} for the plateaus. The same seed gives the same draws, and the same "
            "numbers but for the times."
        ),
    ]
