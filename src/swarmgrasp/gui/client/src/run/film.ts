/* A recorded run: what is to be seen at any time of it. No DOM. */

import type { Pair, Run, RunRobot } from "../messages";

type Columns = "times" | "poses" | "references" | "wind" | "water" | "shortfalls" | "forces" | "angles";
/** What is told of a run; columns are flat. */
export type RunData = Omit<Run, Columns | "kind" | "n" | "seed"> & { readonly [column in Columns]: ArrayLike<number> };

export type Phase = "coming" | "making fast" | "holds" | "lost" | "away";

export type Pose = readonly [number, number, number];

export interface Standing {
  readonly actor: RunRobot;
  readonly phase: Phase;
  readonly force: number;
  /** Of its limit. */
  readonly share: number;
  /** Way of its force in the frame of the object [rad]. */
  readonly way: number;
  /** Where it is, in the frame of the object. */
  readonly at: Pair;
  /** How far it has come, or made fast, 0 to 1. */
  readonly done: number;
}

export interface Moment {
  readonly time: number;
  readonly pose: Pose;
  readonly reference: Pose;
  readonly wind: Pair;
  readonly water: Pair;
  readonly shortfall: number;
  /** How far off its place [m], and turned from its heading [rad]. */
  readonly off: number;
  readonly turned: number;
  readonly robots: readonly Standing[];
}

export class Film {
  /** How far off its place at every instant [m]. */
  readonly offs: Float32Array;
  readonly furthest: number;
  readonly duration: number;

  constructor(readonly data: RunData) {
    const { times, poses, references } = data;
    this.duration = times[times.length - 1] ?? 0;
    this.offs = Float32Array.from({ length: times.length }, (_, i) =>
      Math.hypot(poses[3 * i]! - references[3 * i]!, poses[3 * i + 1]! - references[3 * i + 1]!));
    this.furthest = this.offs.reduce((most, off) => Math.max(most, off), 0);
  }

  /** The instant at or before a time, and how far the next is [0 to 1]. */
  #index(time: number): readonly [number, number] {
    const { times } = this.data;
    let [low, high] = [0, times.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle]! <= time) low = middle;
      else high = middle - 1;
    }
    const next = times[low + 1];
    return [low, next === undefined ? 0 : Math.max(0, Math.min(1, (time - times[low]!) / (next - times[low]!)))];
  }

  at(time: number): Moment {
    const { data } = this;
    const [i, share] = this.#index(time);
    const pose = poseAt(data.poses, i, share);
    const reference = poseAt(data.references, i, share);
    return {
      time, pose, reference,
      wind: [data.wind[2 * i]!, data.wind[2 * i + 1]!],
      water: [data.water[2 * i]!, data.water[2 * i + 1]!],
      shortfall: data.shortfalls[i]!,
      off: Math.hypot(pose[0] - reference[0], pose[1] - reference[1]),
      turned: Math.abs(turnOf(pose[2] - reference[2])),
      robots: data.robots.map((actor, k) => this.#standing(actor, k, i, time)),
    };
  }

  #standing(actor: RunRobot, k: number, i: number, time: number): Standing {
    const { data } = this;
    const many = data.robots.length;
    const holds = actor.there.some(([from, to]) => from <= time && (time < to || to >= this.duration));
    if (holds) {
      const force = data.forces[i * many + k]!;
      const angle = data.angles[i * many + k]!;
      const way = Number.isFinite(angle) ? angle : actor.direction;
      return { actor, phase: "holds", force, share: force / actor.limit, way, at: actor.contact, done: 1 };
    }
    const idle = { actor, force: 0, share: 0, way: actor.direction };
    const route = data.routes.find(({ robot, start, joined }) => robot === actor.name && start <= time && time < joined);
    if (route !== undefined) {
      const coming = time < route.arrival;
      const [from, to] = coming ? [route.start, route.arrival] : [route.arrival, route.joined];
      const done = Math.max(0, Math.min(1, (time - from) / Math.max(to - from, 1e-9)));
      const at = coming ? alongPath(route.points, done) : actor.contact;
      return { ...idle, phase: coming ? "coming" : "making fast", at, done };
    }
    const lost = actor.there.some(([, to]) => to <= time);
    return { ...idle, phase: lost ? "lost" : "away", at: actor.contact, done: 0 };
  }
}

function poseAt(poses: ArrayLike<number>, i: number, share: number): Pose {
  const at = (k: number): number => poses[3 * i + k]!;
  if (share === 0) return [at(0), at(1), at(2)];
  const next = (k: number): number => poses[3 * i + 3 + k]!;
  const mid = (k: number): number => at(k) + share * (next(k) - at(k));
  return [mid(0), mid(1), at(2) + share * turnOf(next(2) - at(2))];
}

/** An angle within half a turn either way. */
export function turnOf(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** The point so far along a path, 0 to 1. */
export function alongPath(points: readonly Pair[], share: number): Pair {
  const steps = points.slice(1).map(([x, y], i) => Math.hypot(x - points[i]![0], y - points[i]![1]));
  let left = share * steps.reduce((sum, step) => sum + step, 0);
  for (const [i, step] of steps.entries()) {
    if (left <= step && step > 0) {
      const [[x, y], [u, v]] = [points[i]!, points[i + 1]!];
      return [x + ((u - x) * left) / step, y + ((v - y) * left) / step];
    }
    left -= step;
  }
  return points[points.length - 1]!;
}

/** A point of the object's frame where its pose puts it. */
export function placedAt([x, y]: Pair, [u, v, heading]: Pose): Pair {
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return [u + cos * x - sin * y, v + sin * x + cos * y];
}

/** Whether a force at a contact leads into the outline. */
export function leadsIn(outline: readonly Pair[], [x, y]: Pair, way: number): boolean {
  const extent = Math.max(...outline.map(([u, v]) => Math.hypot(u, v)));
  const [px, py] = [x + 1e-3 * extent * Math.cos(way), y + 1e-3 * extent * Math.sin(way)];
  let inside = false;
  outline.forEach(([u0, v0], i) => {
    const [u1, v1] = outline[(i + 1) % outline.length]!;
    if (v0 > py !== v1 > py && px < u0 + ((py - v0) / (v1 - v0)) * (u1 - u0)) inside = !inside;
  });
  return inside;
}

/** Minutes and seconds: 3:32. */
export function clock(time: number): string {
  const whole = Math.max(0, Math.floor(time + 1e-9));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}
