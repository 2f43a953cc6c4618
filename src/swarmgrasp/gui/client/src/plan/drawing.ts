/* New zones, no-go stretches and areas, drawn on the plan or put where there is room. */

import type { Pair, ProblemData, StretchData, ZoneData } from "../messages";
import type { Speech } from "../speech";
import { roomiest } from "./adding";
import type { Shape } from "./shape";

export type Drawn = "zone" | "no-go" | "area";

/** Share of the outline that a new stretch takes, and of the hull's extent that a new area takes. */
const [NEW_STRETCH, NEW_AREA] = [0.08, 0.2];

/** A name that no other zone or no-go has. */
function named(problem: ProblemData, kind: Drawn): string {
  const taken = new Set([...(problem.zones ?? []).map(({ name }) => name), ...problem.no_go.map(({ name }) => name)]);
  for (let i = 1; ; i += 1) if (!taken.has(`${kind} ${i}`)) return `${kind} ${i}`;
}

/** The same problem with a stretch more, from one arc length to another by the shorter way. */
export function withStretch(problem: ProblemData, shape: Shape, kind: "zone" | "no-go", from: number, to: number): ProblemData {
  const ahead = shape.wrapped(to - from) <= shape.perimeter / 2;
  const stretch: StretchData = { start: ahead ? from : to, end: ahead ? to : from, name: named(problem, kind) };
  if (kind === "no-go") return { ...problem, no_go: [...problem.no_go, stretch] };
  return withZone(problem, { stretch, area: null, name: stretch.name });
}

/** The same problem with an area more, between two opposite corners in the frame of the file. */
export function withArea(problem: ProblemData, speech: Speech, from: Pair, to: Pair): ProblemData {
  const [[a, b], [c, d]] = [speech.toFile(from), speech.toFile(to)];
  const corners: Pair[] = [[Math.min(a, c), Math.min(b, d)], [Math.max(a, c), Math.min(b, d)], [Math.max(a, c), Math.max(b, d)], [Math.min(a, c), Math.max(b, d)]];
  return withZone(problem, { stretch: null, area: corners.map((corner) => speech.fromFile(corner)), name: named(problem, "area") });
}

function withZone(problem: ProblemData, zone: Pick<ZoneData, "stretch" | "area" | "name">): ProblemData {
  const whole: ZoneData = { attachment: null, half_angle: null, directions: null, ...zone };
  return { ...problem, zones: [...(problem.zones ?? []), whole] };
}

/** The same problem with a stretch or an area more, where there is room. */
export function withNew(problem: ProblemData, shape: Shape, speech: Speech, kind: Drawn): ProblemData {
  if (kind === "area") {
    const { left, right, bottom, top } = shape.box;
    const [x, y] = problem.swarm.outline.origin;
    const [half, high] = [(NEW_AREA * (right - left)) / 2, (NEW_AREA * (top - bottom)) / 2];
    return withArea(problem, speech, [x - half, y - high], [x + half, y + high]);
  }
  const middle = roomiest(shape, problem.swarm.robots);
  const half = (NEW_STRETCH * shape.perimeter) / 2;
  return withStretch(problem, shape, kind, shape.wrapped(middle - half), shape.wrapped(middle + half));
}
