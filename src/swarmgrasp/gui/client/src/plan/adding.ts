/* Robots added, copied and taken away. */

import type { Doc, RobotData } from "../messages";
import { folded, type Shape } from "./shape";
import { movedAlong, movedInside, stanceOf } from "./stance";

/** A name that nobody has. */
export function freshName(doc: Doc, base: string): string {
  const taken = new Set(doc.problem.swarm.robots.map(({ name }) => name));
  taken.add(doc.problem.newcomer.name);
  const root = base.replace(/ \d+$/, "");
  for (let i = doc.problem.swarm.robots.length + 1; ; i += 1) {
    if (!taken.has(`${root} ${i}`)) return `${root} ${i}`;
  }
}

/** Adds robots behind the others, and a number of them in one step. */
export function withRobots(doc: Doc, added: readonly RobotData[]): Doc {
  const { problem } = doc;
  return { ...doc, problem: { ...problem, swarm: { ...problem.swarm, robots: [...problem.swarm.robots, ...added] } } };
}

export function withoutRobot(doc: Doc, name: string): Doc {
  const { problem } = doc;
  const robots = problem.swarm.robots.filter((robot) => robot.name !== name);
  return { ...doc, problem: { ...problem, swarm: { ...problem.swarm, robots } } };
}

/** The arc length in the middle of the longest stretch without a robot. */
export function roomiest(shape: Shape, robots: readonly RobotData[]): number {
  const taken = robots.filter((robot) => !robot.mounted).map((robot) => shape.nearest(robot.contact).along).sort((a, b) => a - b);
  let [best, room] = [shape.perimeter / 4, -1];
  taken.forEach((along, i) => {
    const gap = (taken[i + 1] ?? taken[0]! + shape.perimeter) - along;
    if (gap > room) [best, room] = [along + gap / 2, gap];
  });
  return best;
}

/** A new robot where there is most room, square, of the middle limit. */
export function newRobot(shape: Shape, doc: Doc, word: string): RobotData {
  const { robots } = doc.problem.swarm;
  const { at, edge } = shape.placeAt(roomiest(shape, robots));
  const limits = robots.map(({ limit }) => limit).sort((a, b) => a - b);
  const limit = limits[limits.length >> 1] ?? doc.problem.newcomer.limit;
  const pulls = doc.problem.newcomer.attachment === "pull";
  return {
    contact: at, direction: folded(shape.inward(edge) + (pulls ? Math.PI : 0)), limit, name: freshName(doc, word),
    mounted: false, tolerance: null, reverse_limit: 0, steers: 0, friction: null, least: 0, envelope: null,
    group: "", sectors: null, body: null, lever: 0,
  };
}

/** A copy of a robot, beside it. */
export function duplicated(shape: Shape, doc: Doc, robot: RobotData, gap: number): RobotData {
  const copy = { ...robot, name: freshName(doc, robot.name) };
  if (robot.mounted) return movedInside(shape, copy, [robot.contact[0] + gap, robot.contact[1]]);
  return movedAlong(shape, copy, stanceOf(shape, robot).along + Math.max(gap, doc.problem.spacing));
}

