/* Robots as arrows: where they begin and end on the card. */

import type { RobotData, Pair } from "../messages";
import { reachOf } from "./reach";
import { path, px, type Screen } from "./screen";
import type { Shape } from "./shape";
import { stanceOf, type Stance } from "./stance";

/** From so many robots on, names come without limits. */
export const NAMES_ONLY = 20;
/** From so many on, only the names that matter. */
export const FEW_NAMES = 40;
/** From so many on, arrows are drawn on a canvas. */
export const CANVAS_FROM = 120;

export interface Figure {
  readonly robot: RobotData;
  readonly isNew: boolean;
  /** Null for mounted ones. */
  readonly stance: Stance | null;
  readonly contact: Pair;
  readonly from: Pair;
  readonly to: Pair;
  /** The end that is not at the contact, and the card's angle from the contact to it. */
  readonly free: Pair;
  readonly angle: number;
  readonly width: number;
  /** Outlines of what it can exert, on the card. */
  readonly reach: readonly string[];
  /** Whether it has no direction of its own: an azimuth thruster. */
  readonly round: boolean;
}

export interface Scale {
  readonly largest: number;
  /** Pixels of the largest limit. */
  readonly longest: number;
  readonly many: boolean;
}

const SHORTEST = 26;

export function scaleOf(robots: readonly RobotData[], screen: Screen): Scale {
  let largest = 1e-300;
  for (const robot of robots) largest = Math.max(largest, robot.limit, robot.reverse_limit);
  return { largest, longest: screen.width < 520 ? 48 : 62, many: robots.length > NAMES_ONLY };
}

/** At most half as long again as the longest: a newcomer may be stronger than all of a crowd. */
export function lengthOf(limit: number, scale: Scale): number {
  return Math.max(SHORTEST, Math.min(1.5, limit / scale.largest) * scale.longest);
}

export function figureOf(robot: RobotData, isNew: boolean, shape: Shape, screen: Screen, scale: Scale): Figure {
  const stance = robot.mounted ? null : stanceOf(shape, robot);
  const contact = screen.at(robot.contact);
  const width = isNew ? 5 : scale.many ? 2.2 : 3.2;
  const gap = robot.mounted ? 0 : 3 + width;
  const length = lengthOf(robot.limit, scale);
  const outward = stance?.pushes === true ? robot.direction + Math.PI : robot.direction;
  const near = screen.step(contact, outward, gap);
  const free = screen.step(contact, outward, gap + length);
  const sign = stance?.pushes === true ? -1 : 1;
  const perNewton = (gap + length) / robot.limit;
  const reach = reachOf(robot).map((corners) =>
    path(corners.map(([x, y]) => screen.step(contact, Math.atan2(sign * y, sign * x), perNewton * Math.hypot(x, y))), true));
  const round = robot.steers >= Math.PI && robot.envelope === null && robot.sectors === null;
  const beside = round ? besides(shape, robot.contact) : outward;
  return {
    robot, isNew, stance, contact, width, reach, round,
    free: round ? screen.step(contact, beside, gap + length) : free,
    from: sign < 0 ? free : near,
    to: sign < 0 ? near : free,
    angle: screen.angle(beside),
  };
}

/** Which way a name goes beside one that pushes all round: out of the hull by the shortest way. */
function besides(shape: Shape, [x, y]: Pair): number {
  const { left, right, bottom, top } = shape.box;
  return Math.atan2((2 * y - bottom - top) / (top - bottom), (2 * x - left - right) / (right - left));
}

/** Shaft and head of an arrow; a head as long as the arrow is drawn alone. */
export function arrow(from: Pair, to: Pair, width: number): { shaft: string; head: string } {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [dx / length, dy / length];
  const long = Math.min(3 + 2.3 * width, length);
  const half = (1 + 1.45 * width) * (long / (3 + 2.3 * width));
  const neck: Pair = [to[0] - long * ux, to[1] - long * uy];
  const left: Pair = [neck[0] - half * uy, neck[1] + half * ux];
  const right: Pair = [neck[0] + half * uy, neck[1] - half * ux];
  const end: Pair = [to[0] - 0.7 * long * ux, to[1] - 0.7 * long * uy];
  return { shaft: path([from, end]), head: path([to, left, right], true) };
}

/** An arc on the card, counter-clockwise from one angle to another. */
export function arcPath([x, y]: Pair, radius: number, start: number, end: number): string {
  const at = (angle: number): string => `${px(x + radius * Math.cos(angle))} ${px(y - radius * Math.sin(angle))}`;
  const large = Math.abs(end - start) > Math.PI ? 1 : 0;
  return `M${at(start)}A${px(radius)} ${px(radius)} 0 ${large} ${end > start ? 0 : 1} ${at(end)}`;
}
