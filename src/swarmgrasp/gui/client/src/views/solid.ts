/* A convex body seen from far: what is in front, its edges and its rim. No DOM. */

import type { MeshPart, Triple } from "../messages";

export type Point = readonly [number, number];

/** How the body is turned: about the axis of turning, then towards the viewer [rad]. */
export interface Eye {
  readonly yaw: number;
  readonly pitch: number;
}

export const FIRST_EYE: Eye = { yaw: -0.62, pitch: 0.42 };
const STEEPEST = 1.45;

export interface Axes {
  readonly right: Triple;
  readonly up: Triple;
  readonly near: Triple;
}

/** Directions on the screen and towards the viewer; ahead, to port and turning are x, y and z. */
export function axesOf({ yaw, pitch }: Eye): Axes {
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  const [flat, steep] = [Math.cos(pitch), Math.sin(pitch)];
  return {
    right: [cos, -sin, 0],
    up: [steep * sin, steep * cos, flat],
    near: [-flat * sin, -flat * cos, steep],
  };
}

/** The eye after a drag by so many pixels. */
export function turned({ yaw, pitch }: Eye, dx: number, dy: number): Eye {
  return { yaw: yaw + 0.01 * dx, pitch: Math.max(-STEEPEST, Math.min(STEEPEST, pitch + 0.01 * dy)) };
}

export function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Two corners, the one or two faces they bound, and whether these meet in a crease. */
export interface Edge {
  readonly from: number;
  readonly to: number;
  readonly faces: number[];
  creased: boolean;
}

/** Faces that turn by less than this at an edge are parts of one round face: 5 degrees. */
const SMOOTH = Math.cos((5 * Math.PI) / 180);

/** The shape of a mesh, in its own steps: what does not change as it is turned. */
export class Solid {
  readonly corners: ArrayLike<number>;
  /** Of every face its corners, counter-clockwise. */
  readonly faces: readonly (readonly number[])[];
  readonly normals: ArrayLike<number>;
  readonly edges: readonly Edge[];
  readonly middle: Triple;
  /** Of a ball round the middle that holds all corners. */
  readonly radius: number;

  constructor(mesh: Pick<MeshPart, "corners" | "faces" | "starts" | "normals">, mostEdges: number) {
    this.corners = mesh.corners;
    this.normals = mesh.normals;
    const faces: number[][] = [];
    for (let f = 0; f + 1 < mesh.starts.length; f++) {
      faces.push([...mesh.faces.subarray(mesh.starts[f], mesh.starts[f + 1])]);
    }
    this.faces = faces;
    this.edges = faces.length > mostEdges ? [] : this.#edgesOf(faces);
    const [low, high] = boxOf(mesh.corners);
    this.middle = [0, 1, 2].map((k) => (low[k]! + high[k]!) / 2) as Triple;
    let most = 0;
    for (let i = 0; i < mesh.corners.length; i += 3) {
      most = Math.max(most, Math.hypot(...[0, 1, 2].map((k) => mesh.corners[i + k]! - this.middle[k]!)));
    }
    this.radius = most;
  }

  isFront(face: number, { near }: Axes): boolean {
    return this.#along(face, near) > 0;
  }

  /** How squarely a face looks into a direction, -1 to 1. */
  facing(face: number, direction: Triple): number {
    return this.#along(face, direction) / 127;
  }

  #edgesOf(faces: readonly (readonly number[])[]): Edge[] {
    const found = new Map<number, Edge>();
    faces.forEach((face, f) => {
      face.forEach((from, i) => {
        const to = face[(i + 1) % face.length]!;
        const key = Math.min(from, to) * 65536 + Math.max(from, to);
        const known = found.get(key);
        if (known === undefined) found.set(key, { from, to, faces: [f], creased: true });
        else {
          known.faces.push(f);
          known.creased = this.facing(f, this.#normal(known.faces[0]!)) < SMOOTH;
        }
      });
    });
    return [...found.values()];
  }

  #normal(face: number): Triple {
    const normal = [0, 1, 2].map((k) => this.normals[3 * face + k]!) as Triple;
    const size = Math.hypot(...normal) || 1;
    return normal.map((part) => part / size) as Triple;
  }

  #along(face: number, [x, y, z]: Triple): number {
    const at = 3 * face;
    return this.normals[at]! * x + this.normals[at + 1]! * y + this.normals[at + 2]! * z;
  }
}

function boxOf(corners: ArrayLike<number>): [number[], number[]] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < corners.length; i++) {
    low[i % 3] = Math.min(low[i % 3]!, corners[i]!);
    high[i % 3] = Math.max(high[i % 3]!, corners[i]!);
  }
  return corners.length === 0 ? [[0, 0, 0], [0, 0, 0]] : [low, high];
}

/** Corners of the rim of points, counter-clockwise with y up. */
export function rimOf(points: readonly Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: readonly Point[]): Point[] => {
    const kept: Point[] = [];
    for (const point of list) {
      while (kept.length > 1 && turn(kept[kept.length - 2]!, kept[kept.length - 1]!, point) <= 0) kept.pop();
      kept.push(point);
    }
    kept.pop();
    return kept;
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
}

function turn(a: Point, b: Point, c: Point): number {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** How far off an edge may lead, as corners are whole steps. */
const SLACK = 0.02;

/** Whether the edge between two corners is parallel to a direction. */
export function isAlong(corners: ArrayLike<number>, from: number, to: number, direction: Triple): boolean {
  const edge = [0, 1, 2].map((k) => corners[3 * to + k]! - corners[3 * from + k]!) as Triple;
  const sizes = Math.hypot(...edge) * Math.hypot(...direction);
  return sizes > 0 && Math.abs(dot(edge, direction)) >= (1 - SLACK * SLACK) * sizes;
}
