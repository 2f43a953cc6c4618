/* Another outline: what stood on the old one keeps its edge and its share of the way along it. */

import type { OutlineData, Pair, ProblemData, StretchData } from "../messages";
import { distance, Shape } from "./shape";
import { stanceOf } from "./stance";

const SAME = 1e-6;

/** A problem whose outline has a corner moved. */
export function withCorner(problem: ProblemData, corner: number, to: Pair): ProblemData {
  const vertices = problem.swarm.outline.vertices.map((old, i): Pair => (i === corner ? to : old));
  return moved(problem, { ...problem.swarm.outline, vertices }, (edge, share) => [edge, share]);
}

/** A problem whose outline has one corner more, in the middle of an edge. */
export function withNewCorner(problem: ProblemData, edge: number): ProblemData {
  const { outline } = problem.swarm;
  const shape = new Shape(outline);
  const middle = shape.onEdge(edge, shape.lengthOf(edge) / 2);
  const vertices = [...outline.vertices.slice(0, edge + 1), middle, ...outline.vertices.slice(edge + 1)];
  const names = [...outline.edge_names];
  names.splice(edge + 1, 0, names[edge] ?? "");
  return moved(problem, { ...outline, vertices, edge_names: names }, (old, share) => {
    if (old !== edge) return [old > edge ? old + 1 : old, share];
    return share <= 0.5 ? [edge, 2 * share] : [edge + 1, 2 * share - 1];
  });
}

/** A problem whose outline has one corner less. */
export function withoutCorner(problem: ProblemData, corner: number): ProblemData {
  const { outline } = problem.swarm;
  const count = outline.vertices.length;
  if (count <= 3) return problem;
  const shape = new Shape(outline);
  const before = (corner - 1 + count) % count;
  const whole = shape.lengthOf(before) + shape.lengthOf(corner);
  const vertices = outline.vertices.filter((_, i) => i !== corner);
  const names = outline.edge_names.filter((_, i) => i !== corner);
  const renamed = (edge: number): number => (edge > corner ? edge - 1 : edge);
  const joined = corner === 0 ? count - 2 : before;
  return moved(problem, { ...outline, vertices, edge_names: names }, (edge, share) => {
    if (edge === before) return [joined, (share * shape.lengthOf(before)) / whole];
    if (edge === corner) return [joined, (shape.lengthOf(before) + share * shape.lengthOf(corner)) / whole];
    return [renamed(edge), share];
  });
}

type Carry = (edge: number, share: number) => readonly [number, number];

function moved(problem: ProblemData, outline: OutlineData, carry: Carry): ProblemData {
  const { swarm } = problem;
  const old = new Shape(swarm.outline);
  const now = new Shape(outline);
  const carried = (edge: number, along: number): number => {
    const share = Math.max(0, Math.min(1, old.wrapped(along - old.starts[edge]!) / old.lengthOf(edge)));
    const [to, part] = carry(edge, share);
    return now.starts[to]! + part * now.lengthOf(to);
  };
  const along = (s: number): number => now.wrapped(carried(old.edgeAt(s), s));
  const stretch = <S extends StretchData>(one: S): S => ({ ...one, start: along(one.start), end: along(one.end) });
  const robots = swarm.robots.map((robot) => {
    if (robot.mounted) return robot;
    const stance = stanceOf(old, robot);
    const to = carry(stance.edge, 0)[0];
    const turn = now.inward(to) - old.inward(stance.edge);
    return {
      ...robot, contact: now.placeAt(carried(stance.edge, stance.along)).at, direction: robot.direction + turn,
      sectors: robot.sectors?.map(([start, end]): Pair => [start + turn, end + turn]) ?? null,
    };
  });
  return {
    ...problem,
    swarm: { ...swarm, outline: withOrigin(outline, swarm.outline), robots, characteristic_length: armOf(swarm, outline) },
    zones: problem.zones?.map((zone) => (zone.stretch === null ? zone : { ...zone, stretch: stretch(zone.stretch) })) ?? null,
    no_go: problem.no_go.map(stretch),
  };
}

/** The centroid follows where the origin was the centroid, and stays where the file said otherwise. */
function withOrigin(outline: OutlineData, old: OutlineData): OutlineData {
  const size = new Shape(old).perimeter;
  if (distance(centroid(old.vertices), old.origin) > SAME * size) return outline;
  return { ...outline, origin: centroid(outline.vertices) };
}

function armOf(swarm: ProblemData["swarm"], outline: OutlineData): number {
  const arm = (one: OutlineData): number => Math.max(...one.vertices.map((corner) => distance(corner, one.origin)));
  const usual = arm(swarm.outline);
  if (Math.abs(usual - swarm.characteristic_length) > SAME * usual) return swarm.characteristic_length;
  return arm(withOrigin(outline, swarm.outline));
}

export function centroid(vertices: readonly Pair[]): Pair {
  let [area, x, y] = [0, 0, 0];
  vertices.forEach((from, i) => {
    const to = vertices[(i + 1) % vertices.length]!;
    const cross = from[0] * to[1] - to[0] * from[1];
    area += cross;
    x += cross * (from[0] + to[0]);
    y += cross * (from[1] + to[1]);
  });
  return [x / (3 * area), y / (3 * area)];
}
