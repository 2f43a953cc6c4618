/* An outline and what lies on it: places by arc length, nearest points, square directions. */

import type { OutlineData, Pair, StretchData } from "../messages";

/** Corners closer than this share of the outline are one place. */
const SAME = 1e-9;

export interface Place {
  /** Arc length from the first vertex, counter-clockwise. */
  readonly along: number;
  readonly edge: number;
  readonly at: Pair;
}

export interface Near extends Place {
  readonly distance: number;
}

export class Shape {
  readonly vertices: readonly Pair[];
  readonly names: readonly string[];
  /** About which wrenches turn. */
  readonly origin: Pair;
  /** Arc length at the start of each edge. */
  readonly starts: readonly number[];
  readonly perimeter: number;
  readonly #angles: readonly number[];

  constructor(outline: OutlineData) {
    this.vertices = outline.vertices;
    this.names = outline.edge_names;
    this.origin = outline.origin;
    const starts: number[] = [];
    let along = 0;
    this.vertices.forEach((from, i) => {
      starts.push(along);
      along += distance(from, this.corner(i + 1));
    });
    this.starts = starts;
    this.perimeter = along;
    this.#angles = this.vertices.map((from, i) => {
      const to = this.corner(i + 1);
      return Math.atan2(to[1] - from[1], to[0] - from[0]);
    });
  }

  corner(i: number): Pair {
    return this.vertices[((i % this.vertices.length) + this.vertices.length) % this.vertices.length]!;
  }

  /** An arc length within the first round. */
  wrapped(along: number): number {
    return ((along % this.perimeter) + this.perimeter) % this.perimeter;
  }

  lengthOf(edge: number): number {
    return (this.starts[edge + 1] ?? this.perimeter) - this.starts[edge]!;
  }

  /** The edge that an arc length lies on; at a corner the one that starts there. */
  edgeAt(along: number): number {
    const s = this.wrapped(along);
    let [low, high] = [0, this.starts.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.starts[middle]! <= s + SAME * this.perimeter) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  placeAt(along: number): Place {
    const s = this.wrapped(along);
    const edge = this.edgeAt(s);
    const t = Math.max(0, Math.min(1, (s - this.starts[edge]!) / this.lengthOf(edge)));
    const [from, to] = [this.corner(edge), this.corner(edge + 1)];
    return { along: s, edge, at: [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])] };
  }

  nearest(point: Pair): Near {
    let best: Near = { along: 0, edge: 0, at: this.corner(0), distance: Infinity };
    this.vertices.forEach((from, edge) => {
      const to = this.corner(edge + 1);
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      const length2 = dx * dx + dy * dy;
      const t = Math.max(0, Math.min(1, ((point[0] - from[0]) * dx + (point[1] - from[1]) * dy) / length2));
      const at: Pair = [from[0] + t * dx, from[1] + t * dy];
      const far = distance(point, at);
      if (far < best.distance) {
        best = { along: this.wrapped(this.starts[edge]! + t * Math.sqrt(length2)), edge, at, distance: far };
      }
    });
    return best;
  }

  /** Direction of an edge [rad], counter-clockwise round the outline. */
  tangent(edge: number): number {
    return this.#angles[edge]!;
  }

  /** Direction square into the hull at an edge [rad]. */
  inward(edge: number): number {
    return this.#angles[edge]! + Math.PI / 2;
  }

  nameOf(edge: number): string {
    return this.names[edge] || `edge ${edge + 1}`;
  }

  contains(point: Pair): boolean {
    let inside = false;
    this.vertices.forEach((from, i) => {
      const to = this.corner(i + 1);
      if (from[1] > point[1] !== to[1] > point[1]) {
        const x = from[0] + ((point[1] - from[1]) / (to[1] - from[1])) * (to[0] - from[0]);
        if (point[0] < x) inside = !inside;
      }
    });
    return inside;
  }

  /** Length of a stretch, which may run across the first vertex. */
  spanOf(stretch: StretchData): number {
    const span = stretch.end - stretch.start;
    return span < 0 ? span + this.perimeter : span;
  }

  /** Corners of a stretch, one row for each edge that it runs along. */
  pieces(start: number, end: number): { edge: number; from: Pair; to: Pair; start: number; end: number }[] {
    const found = [];
    let at = start;
    const last = end < start ? end + this.perimeter : end;
    for (let guard = 0; guard <= this.vertices.length && at < last - SAME * this.perimeter; guard += 1) {
      const edge = this.edgeAt(at);
      const left = this.lengthOf(edge) - (this.wrapped(at) - this.starts[edge]!);
      const until = Math.min(last, at + Math.max(left, SAME * this.perimeter));
      const from = this.placeAt(at).at;
      const to = until === last ? this.onEdge(edge, this.wrapped(at) - this.starts[edge]! + until - at) : this.corner(edge + 1);
      found.push({ edge, from, to, start: at, end: until });
      at = until;
    }
    return found;
  }

  onEdge(edge: number, offset: number): Pair {
    const [from, to] = [this.corner(edge), this.corner(edge + 1)];
    const t = offset / this.lengthOf(edge);
    return [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
  }

  get box(): { left: number; right: number; bottom: number; top: number } {
    const xs = this.vertices.map(([x]) => x);
    const ys = this.vertices.map(([, y]) => y);
    return { left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys) };
  }
}

export function distance(a: Pair, b: Pair): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** The same angle within (-pi, pi]. */
export function folded(angle: number): number {
  const turn = 2 * Math.PI;
  const within = ((angle % turn) + turn) % turn;
  return within > Math.PI ? within - turn : within;
}

/** Whether a force at an edge leads into the hull. */
export function pushes(shape: Shape, edge: number, direction: number): boolean {
  return Math.abs(folded(direction - shape.inward(edge))) <= Math.PI / 2;
}

/** How far a force is off square, and from which square: into the hull or out of it [rad]. */
export function offSquare(shape: Shape, edge: number, direction: number): number {
  const inward = shape.inward(edge);
  return folded(direction - (pushes(shape, edge, direction) ? inward : inward + Math.PI));
}
