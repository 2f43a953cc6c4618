/* Gestures: what a hand, or a key in its place, does to the document. */

import type { Store } from "../state";
import type { Pair, ProblemData, RobotData, StretchData } from "../messages";
import { withArea, withStretch } from "./drawing";
import type { Figure } from "./figures";
import type { Grip } from "./handles";
import { withCorner } from "./outline";
import type { PushLayer } from "./push";
import { folded, type Shape } from "./shape";
import type { Stage } from "./stage";
import { movedAlong, movedInside, stanceOf, turnedOff, turnedTo } from "./stance";

const DEGREE = Math.PI / 180;
const NEAR_CORNER = 7;
/** Pixels from the outline within which a zone is begun. */
const NEAR_OUTLINE = 24;

/** What a pointer or a key says beside where it is. */
export interface Held {
  readonly shift: boolean;
  readonly alt: boolean;
}

/** Moves a robot so that its contact comes to a point. */
export function dragRobot(store: Store, stage: Stage, name: string, to: Pair, { shift }: Held): void {
  const { shape, speech } = stage;
  store.editRobot(name, (robot) => {
    if (!robot.mounted) return movedAlong(shape, robot, shape.nearest(to).along);
    const [x, y] = shift ? rounded(speech.toFile(to)) : speech.toFile(to);
    return movedInside(shape, robot, speech.fromFile([x, y]));
  }, true);
}

function rounded([x, y]: Pair): Pair {
  return [Math.round(x), Math.round(y)];
}

/** Moves what a knob holds to a point. */
export function dragGrip(store: Store, stage: Stage, push: PushLayer, grip: Grip, at: Pair, held: Held): void {
  const { shape, screen } = stage;
  const to = screen.model(at);
  switch (grip.kind) {
    case "turn":
      return dragTurn(store, stage, grip.robot, at, held);
    case "sector":
      return store.editRobot(grip.robot, (robot) => {
        const figure = stage.figures.find((one) => one.robot.name === grip.robot)!;
        const off = Math.abs(folded(wayOut(stage, figure, at) - outwardOf(figure, robot)));
        return { ...robot, steers: stepped(Math.min(off, Math.PI), held.shift) };
      }, true);
    case "fan":
      return store.editNewcomer((newcomer) => {
        const figure = stage.newcomer!;
        const middle = shape.inward(figure.stance!.edge) + Math.PI;
        const off = Math.abs(folded(wayOut(stage, figure, at) - middle));
        return { ...newcomer, half_angle: stepped(Math.min(off, Math.PI / 2), held.shift) };
      }, true);
    case "zone":
    case "no-go": {
      const near = shape.nearest(to);
      return store.editProblem((problem) => moveEnd(shape, problem, grip, snapped(stage, near.along)), true);
    }
    case "area":
      return store.editProblem((problem) => ({
        ...problem, zones: problem.zones!.map((zone, i) => (i !== grip.index ? zone : {
          ...zone, area: zone.area!.map((corner, k): Pair => (k === grip.corner ? gridded(stage, to, held) : corner)),
        })),
      }), true);
    case "vertex":
      return store.editProblem((problem) => withCorner(problem, grip.corner, gridded(stage, to, held)), true);
    case "edge":
      return;
    case "force":
      return push.pull(at);
    case "torque":
      return push.twist(at);
  }
}

/**
 * Draws a new zone from a pixel to another: of a newcomer inside an area, else along the outline, with
 * Shift a no-go; nothing where neither is near.
 */
export function drawNew(store: Store, stage: Stage, before: ProblemData, from: Pair, to: Pair, { shift }: Held): void {
  const { shape, screen, speech } = stage;
  if (before.newcomer.mounted) {
    store.editProblem(() => withArea(before, speech, screen.model(from), screen.model(to)), true);
    return;
  }
  const [start, end] = [from, to].map((at) => shape.nearest(screen.model(at)));
  if (start!.distance * screen.scale > NEAR_OUTLINE) return;
  const [begin, stop] = [snapped(stage, start!.along), snapped(stage, end!.along)];
  if (begin !== stop) store.editProblem(() => withStretch(before, shape, shift ? "no-go" : "zone", begin, stop), true);
}

function gridded({ speech }: Stage, to: Pair, { shift }: Held): Pair {
  return shift ? speech.fromFile(rounded(speech.toFile(to))) : to;
}

function stepped(angle: number, inFives: boolean): number {
  const step = (inFives ? 5 : 1) * DEGREE;
  return Math.round(angle / step) * step;
}

function outwardOf(figure: Figure, robot: RobotData): number {
  return figure.stance?.pushes === true ? robot.direction + Math.PI : robot.direction;
}

/** The model's direction from a contact to a pixel. */
function wayOut({ screen }: Stage, { contact }: Figure, at: Pair): number {
  return screen.direction(at[0] - contact[0], contact[1] - at[1]);
}

function dragTurn(store: Store, stage: Stage, name: string, at: Pair, held: Held): void {
  const figure = stage.figures.find((one) => one.robot.name === name);
  if (figure === undefined) return;
  if (held.alt) {
    const { contact } = figure;
    const length = Math.hypot(at[0] - contact[0], at[1] - contact[1]) - 11;
    const unit = stage.speech.forceUnit(stage.scale.largest).size;
    const limit = Math.max(1, Math.round((length / stage.scale.longest) * stage.scale.largest / unit)) * unit;
    store.editRobot(name, (robot) => ({ ...robot, limit }), true);
    return;
  }
  const out = wayOut(stage, figure, at);
  const direction = figure.stance?.pushes === true ? out + Math.PI : out;
  store.editRobot(name, (robot) => turnedTo(stage.shape, robot, folded(direction), held.shift), true);
}

/** An arc length, at a corner within a few pixels of it. */
function snapped({ shape, screen }: Stage, along: number): number {
  const within = NEAR_CORNER / screen.scale;
  for (const start of shape.starts) {
    const off = Math.abs(along - start);
    if (Math.min(off, shape.perimeter - off) < within) return start;
  }
  return along;
}

type EndGrip = Extract<Grip, { kind: "zone" | "no-go" }>;

/** A problem with an end of a stretch moved; its ends do not pass each other. */
export function moveEnd(shape: Shape, problem: ProblemData, grip: EndGrip, along: number): ProblemData {
  const moved = (stretch: StretchData): StretchData => {
    if (grip.end === "both") return { ...stretch, start: along, end: along };
    const least = 1e-6 * shape.perimeter;
    const span = shape.spanOf(stretch);
    const by = grip.end === "start" ? folding(shape, along - stretch.start) : folding(shape, along - stretch.end);
    const left = grip.end === "start" ? span - by : span + by;
    if (left < least || left > shape.perimeter - least) return stretch;
    return { ...stretch, [grip.end]: along };
  };
  if (grip.kind === "no-go") {
    return { ...problem, no_go: problem.no_go.map((stretch, i) => (i === grip.index ? moved(stretch) : stretch)) };
  }
  return {
    ...problem, zones: problem.zones!.map((zone, i) =>
      (i === grip.index && zone.stretch !== null ? { ...zone, stretch: moved(zone.stretch) } : zone)),
  };
}

/** A way round the outline, the shorter one. */
function folding(shape: Shape, by: number): number {
  const within = shape.wrapped(by);
  return within > shape.perimeter / 2 ? within - shape.perimeter : within;
}

// -- keys --------------------------------------------------------------------------------

/** An arrow key: which way on the card. */
export function arrowOf(key: string): readonly [number, number] | null {
  return ({ ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as const)[key] ?? null;
}

/** Which way round the outline an arrow key leads at an edge. */
function roundWay({ shape, screen }: Stage, edge: number, [right, up]: readonly [number, number]): number {
  const angle = screen.angle(shape.tangent(edge));
  const along = right * Math.cos(angle) + up * Math.sin(angle);
  return Math.abs(along) > 0.2 ? Math.sign(along) : right + up;
}

/** Moves the chosen robot by a unit of length, or by ten. */
export function nudgeRobot(store: Store, stage: Stage, name: string, way: readonly [number, number], by: number): void {
  const { shape, screen, speech } = stage;
  const step = speech.data.length.size * by;
  store.editRobot(name, (robot) => {
    if (robot.mounted) {
      const direction = screen.direction(way[0], way[1]);
      return movedInside(shape, robot, [
        robot.contact[0] + step * Math.cos(direction), robot.contact[1] + step * Math.sin(direction),
      ]);
    }
    const { edge, along } = stanceOf(shape, robot);
    return movedAlong(shape, robot, along + step * roundWay(stage, edge, way));
  }, true);
}

/** Moves what a knob holds by a step of its own. */
export function nudgeGrip(store: Store, stage: Stage, push: PushLayer, grip: Grip, way: readonly [number, number], by: number): void {
  const { shape, screen, speech } = stage;
  const step = speech.data.length.size * by;
  const direction = screen.direction(way[0], way[1]);
  const shifted = ([x, y]: Pair): Pair => [x + step * Math.cos(direction), y + step * Math.sin(direction)];
  const more = (way[0] + way[1]) * by * DEGREE;
  switch (grip.kind) {
    case "turn":
      return turnRobot(store, stage, grip.robot, way[0] + way[1] > 0 ? by : -by);
    case "sector":
      return store.editRobot(grip.robot, (robot) => ({ ...robot, steers: Math.max(0, Math.min(Math.PI, robot.steers + more)) }), true);
    case "fan":
      return store.editNewcomer((one) => ({
        ...one, half_angle: Math.max(0, Math.min(Math.PI / 2, (one.half_angle ?? Math.PI / 2) + more)),
      }), true);
    case "zone":
    case "no-go":
      return store.editProblem((problem) => {
        const stretch = grip.kind === "zone" ? problem.zones![grip.index]!.stretch! : problem.no_go[grip.index]!;
        const along = grip.end === "end" ? stretch.end : stretch.start;
        const sign = roundWay(stage, shape.edgeAt(along), way);
        return moveEnd(shape, problem, grip, shape.wrapped(along + sign * step));
      }, true);
    case "area":
      return store.editProblem((problem) => ({
        ...problem, zones: problem.zones!.map((zone, i) => (i !== grip.index ? zone : {
          ...zone, area: zone.area!.map((corner, k) => (k === grip.corner ? shifted(corner) : corner)),
        })),
      }), true);
    case "vertex":
      return store.editProblem((problem) => withCorner(problem, grip.corner, shifted(shape.corner(grip.corner))), true);
    case "edge":
      return;
    case "force":
    case "torque":
      return push.nudge(grip.kind, way[0], way[1], by);
  }
}

/** Turns a robot counter-clockwise by degrees. */
export function turnRobot(store: Store, { shape }: Stage, name: string, degrees: number): void {
  store.editRobot(name, (robot) => {
    const off = robot.mounted ? robot.direction : stanceOf(shape, robot).off;
    return turnedOff(shape, robot, off + degrees * DEGREE);
  }, true);
}
