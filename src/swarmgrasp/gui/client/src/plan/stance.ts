/* How a robot stands on the hull, and how it stands after a move. */

import type { Pair, RobotData } from "../messages";
import type { Speech } from "../speech";
import { distance, folded, offSquare, pushes, type Shape } from "./shape";

/** Furthest off square that a hand turns a robot on the outline to. */
export const MOST_OFF = (88 * Math.PI) / 180;
const SQUARE_WITHIN = (3 * Math.PI) / 180;
const FIVE = (5 * Math.PI) / 180;
const AT_CORNER = 1e-6;

export interface Stance {
  readonly along: number;
  readonly edge: number;
  readonly pushes: boolean;
  /** Off square, counter-clockwise [rad]. */
  readonly off: number;
}

/** Of robots that stay as they are the stance is worked out once. */
const known = new WeakMap<Shape, WeakMap<RobotData, Stance>>();

/** The stance of a robot on the outline; at a corner it stands on the side that it is squarer to. */
export function stanceOf(shape: Shape, robot: RobotData): Stance {
  let stances = known.get(shape);
  if (stances === undefined) known.set(shape, stances = new WeakMap());
  let stance = stances.get(robot);
  if (stance === undefined) stances.set(robot, stance = newStance(shape, robot));
  return stance;
}

function newStance(shape: Shape, robot: RobotData): Stance {
  const near = shape.nearest(robot.contact);
  const edges = [near.edge, near.edge + 1, near.edge - 1 + shape.vertices.length]
    .map((edge) => edge % shape.vertices.length)
    .filter((edge) => edge === near.edge || touches(shape, edge, near.at));
  let edge = near.edge;
  for (const other of edges) {
    const [mine, theirs] = [offSquare(shape, edge, robot.direction), offSquare(shape, other, robot.direction)];
    if (Math.abs(theirs) < Math.abs(mine) - 1e-12) edge = other;
  }
  return {
    along: near.along, edge,
    pushes: pushes(shape, edge, robot.direction),
    off: offSquare(shape, edge, robot.direction),
  };
}

function touches(shape: Shape, edge: number, at: Pair): boolean {
  const near = AT_CORNER * shape.perimeter;
  return distance(shape.corner(edge), at) < near || distance(shape.corner(edge + 1), at) < near;
}

/** How far along its edge a robot stands [m]. */
export function alongEdge(shape: Shape, { along, edge }: { along: number; edge: number }): number {
  return Math.min(shape.lengthOf(edge), shape.wrapped(along - shape.starts[edge]!));
}

function square(shape: Shape, edge: number, isPush: boolean): number {
  return shape.inward(edge) + (isPush ? 0 : Math.PI);
}

function turned(robot: RobotData, direction: number): RobotData {
  const by = direction - robot.direction;
  const sectors = robot.sectors?.map(([start, end]): Pair => [start + by, end + by]) ?? null;
  return { ...robot, direction, sectors };
}

/** A robot moved along the outline: a push keeps its angle to the side, a line where it leads. */
export function movedAlong(shape: Shape, robot: RobotData, along: number): RobotData {
  const { edge: before, pushes: isPush } = stanceOf(shape, robot);
  const { at, edge } = shape.placeAt(along);
  const wanted = isPush ? robot.direction + shape.inward(edge) - shape.inward(before) : robot.direction;
  return { ...turned(robot, clamped(shape, edge, isPush, wanted)), contact: at };
}

function clamped(shape: Shape, edge: number, isPush: boolean, direction: number): number {
  const middle = square(shape, edge, isPush);
  const off = folded(direction - middle);
  return folded(middle + Math.max(-MOST_OFF, Math.min(MOST_OFF, off)));
}

/** A robot on the outline turned to a direction: square within 3 degrees, in fives where asked. */
export function turnedTo(shape: Shape, robot: RobotData, direction: number, inFives: boolean): RobotData {
  if (robot.mounted) return turned(robot, inFives ? Math.round(direction / FIVE) * FIVE : folded(direction));
  const { edge, pushes: isPush } = stanceOf(shape, robot);
  const middle = square(shape, edge, isPush);
  let off = folded(direction - middle);
  if (inFives) off = Math.round(off / FIVE) * FIVE;
  else if (Math.abs(off) < SQUARE_WITHIN) off = 0;
  return turned(robot, clamped(shape, edge, isPush, middle + off));
}

/** A robot with another angle off square [rad]. */
export function turnedOff(shape: Shape, robot: RobotData, off: number): RobotData {
  if (robot.mounted) return turned(robot, folded(off));
  const { edge, pushes: isPush } = stanceOf(shape, robot);
  return turned(robot, clamped(shape, edge, isPush, square(shape, edge, isPush) + off));
}

/** The same robot the other way: a push becomes a pull. */
export function reversed(robot: RobotData): RobotData {
  return turned(robot, folded(robot.direction + Math.PI));
}

/** A mounted robot moved, but not out of the hull. */
export function movedInside(shape: Shape, robot: RobotData, to: Pair): RobotData {
  return { ...robot, contact: shape.contains(to) ? to : shape.nearest(to).at };
}

/** "starboard side, 18.0 m along": where a robot is. */
export function placeWords(shape: Shape, robot: RobotData, speech: Speech): string {
  if (robot.mounted) return speech.point(robot.contact);
  const stance = stanceOf(shape, robot);
  return `${shape.nameOf(stance.edge)}, ${speech.length(alongEdge(shape, stance))} along`;
}

/** A sentence of where a robot stands and what it does there. */
export function stanceWords(shape: Shape, robot: RobotData, speech: Speech): string {
  const where = robot.mounted ? "inside, at" : "on";
  const place = `${where} ${placeWords(shape, robot, speech)}`;
  if (robot.steers >= Math.PI) return `${place}, ${speech.force(robot.limit)} any way`;
  const way = speech.bearingOf(robot.direction);
  if (robot.mounted) return `${place}, ${speech.force(robot.limit)} towards ${way}`;
  const { pushes: isPush, off } = stanceOf(shape, robot);
  const angle = Math.abs(off) < 0.5 * (Math.PI / 180) ? "square" : `${speech.angle(off)} off square`;
  return `${place}, ${isPush ? "pushes" : "pulls"} ${speech.force(robot.limit)} towards ${way}, ${angle}`;
}
