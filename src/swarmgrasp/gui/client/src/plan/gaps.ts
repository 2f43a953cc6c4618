/* Directions that a thruster must not push in: the gaps between its sectors. Counter-clockwise [rad]. */

import type { Pair, RobotData } from "../messages";

const TURN = 2 * Math.PI;
/** Of a gap that is added. */
const NEW_GAP = Math.PI / 6;
/** A gap that is less is none, and a sector that is less does not remain. */
const LEAST = 1e-9;

function wrapped(angle: number): number {
  return ((angle % TURN) + TURN) % TURN;
}

/** What is left of the turn beside some arcs, each from its first to its second; they do not overlap. */
function between(arcs: readonly Pair[]): Pair[] {
  const sorted = arcs.map(([start, end]): Pair => [wrapped(start), wrapped(start) + end - start]).sort((a, b) => a[0] - b[0]);
  return sorted.flatMap(([, end], i): Pair[] => {
    const next = sorted[i + 1]?.[0] ?? sorted[0]![0] + TURN;
    return next - end > LEAST ? [[end, next]] : [];
  });
}

/** Whether it pushes all round, but for gaps. */
export function isAllRound({ steers, sectors, envelope }: RobotData): boolean {
  return envelope === null && (steers >= Math.PI || sectors !== null);
}

/** The gaps of one that pushes all round but for these. */
export function gapsOf({ sectors }: RobotData): Pair[] {
  return sectors === null ? [] : between(sectors.map(([start, end]): Pair => [start, start + wrapped(end - start)]));
}

/** The same robot with other gaps; where two meet they are one. */
export function withGaps(robot: RobotData, gaps: readonly Pair[]): RobotData {
  const arcs = joined(gaps);
  if (arcs.length === 0) return { ...robot, sectors: null, steers: Math.PI };
  const sectors = between(arcs);
  if (sectors.length === 0) return robot;
  const widest = sectors.reduce((best, one) => (one[1] - one[0] > best[1] - best[0] ? one : best));
  return { ...robot, sectors, steers: 0, direction: (widest[0] + widest[1]) / 2 };
}

/** One gap more, in the middle of the widest sector. */
export function withNewGap(robot: RobotData): RobotData {
  const sectors: readonly Pair[] = robot.sectors ?? [[robot.direction, robot.direction + TURN]];
  const widest = sectors.reduce((best, one) => (wrapped(one[1] - one[0] - LEAST) > wrapped(best[1] - best[0] - LEAST) ? one : best));
  const middle = widest[0] + (wrapped(widest[1] - widest[0] - LEAST) + LEAST) / 2;
  const half = Math.min(NEW_GAP, (wrapped(widest[1] - widest[0] - LEAST) + LEAST) / 3) / 2;
  return withGaps(robot, [...gapsOf(robot), [middle - half, middle + half]]);
}

/**
 * A gap with another end. One that is typed may be anywhere round, even at the other end, and leaves
 * no gap then; one that is moved stops before the other.
 */
export function withEnd([start, end]: Pair, which: 0 | 1, to: number, moving: boolean): Pair {
  const width = wrapped(which === 0 ? end - to : to - start);
  const grows = width - (end - start);
  if (moving && (width < LEAST || Math.abs(grows) > Math.PI)) return [start, end];
  return which === 0 ? [end - width, end] : [start, start + width];
}

function joined(gaps: readonly Pair[]): Pair[] {
  const sorted = gaps.filter(([start, end]) => end - start > LEAST).map(([start, end]): Pair => [wrapped(start), wrapped(start) + end - start])
    .sort((a, b) => a[0] - b[0]);
  const found: Pair[] = [];
  for (const [start, end] of sorted) {
    const last = found[found.length - 1];
    if (last !== undefined && start <= last[1] + LEAST) last[1] = Math.max(last[1], end);
    else found.push([start, end]);
  }
  const [first, last] = [found[0], found[found.length - 1]];
  if (found.length > 1 && last![1] >= first![0] + TURN - LEAST) {
    found.pop();
    found[0] = [last![0] - TURN, Math.max(first![1], last![1] - TURN)];
  }
  return found;
}
