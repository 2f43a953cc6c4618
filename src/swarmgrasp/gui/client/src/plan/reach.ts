/* What a robot can exert, as outlines of its force sets [N, N] about its contact. */

import type { Pair, RobotData } from "../messages";

const CHORD = Math.PI / 36;

function arc(radius: number, start: number, end: number): Pair[] {
  const count = Math.max(1, Math.ceil((end - start) / CHORD));
  return Array.from({ length: count + 1 }, (_, i): Pair => {
    const angle = start + ((end - start) * i) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

function fan(radius: number, least: number, start: number, end: number): Pair[] {
  if (end - start >= 2 * Math.PI - 1e-9) return arc(radius, start, end);
  const inner: Pair[] = least > 0 ? arc(least, start, end).reverse() : [[0, 0]];
  return [...inner, ...arc(radius, start, end)];
}

/** Outlines of what it can exert, in the object's frame; of one that pushes along a line none. */
export function reachOf(robot: RobotData): Pair[][] {
  const { limit, direction, steers, least } = robot;
  if (robot.envelope !== null) return [robot.envelope.map((force) => turnedBy(force, direction))];
  if (robot.sectors !== null) return robot.sectors.map(([start, end]) => fan(limit, 0, start, end));
  if (robot.friction !== null && robot.friction > 0) {
    const mu = robot.friction;
    const cone: Pair[] = [[least, -mu * least], [limit, -mu * limit], [limit, mu * limit], [least, mu * least]];
    return [cone.map((force) => turnedBy(force, direction))];
  }
  if (steers <= 0) return [];
  const half = Math.min(steers, Math.PI);
  const ahead = fan(limit, least, direction - half, direction + half);
  if (robot.reverse_limit <= 0) return [ahead];
  const astern = direction + Math.PI;
  return [ahead, fan(robot.reverse_limit, 0, astern - half, astern + half)];
}

function turnedBy([x, y]: Pair, angle: number): Pair {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [cos * x - sin * y, sin * x + cos * y];
}
