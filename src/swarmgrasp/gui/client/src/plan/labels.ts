/* Names beside arrows, so that they cover neither each other nor what is drawn. */

import type { Pair } from "../messages";

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Wanted {
  readonly key: string;
  /** The end of its arrow that it stands beyond. */
  readonly end: Pair;
  /** On the card, counter-clockwise from its right [rad]: from the other end to that. */
  readonly angle: number;
  readonly width: number;
  readonly height: number;
  /** Pixels from the end. */
  readonly off: number;
  /** Whether it may be left out where it finds no room. */
  readonly optional: boolean;
  /** Whether it belongs inside the hull, and may stand there. */
  readonly inside: boolean;
}

export interface Placed {
  readonly key: string;
  readonly at: Pair;
  readonly anchor: "start" | "middle" | "end";
  readonly box: Box;
  readonly turn: number;
}

const TURNS = [0, 26, -26, 52, -52, 77, -77, 103, -103].map((degrees) => (degrees * Math.PI) / 180);
/** Pixels further away, where those inside leave each other little room, and a pixel's cost. */
const FURTHER = [0, 12, 26];
const PER_PIXEL = 0.08;
const ANCHORED = 0.38;
const TOO_DEAR = 40;
/** For a name over the hull: more than any turn that brings it beside the hull. */
const OVER_HULL = 80;
const [OVER_OWN_HULL, OVER_SIDE] = [1, 4];

export interface Room {
  readonly width: number;
  readonly height: number;
  /** What no label should cover, dear as another label: weather, scale, bars. */
  readonly kept: readonly Box[];
  readonly hull: Box;
  /** Of the outline. */
  readonly sides: readonly (readonly [Pair, Pair])[];
  readonly arrows: readonly (readonly [Pair, Pair])[];
}

/** Places labels in their order, each where it costs the least; `before` keeps them from jumping. */
export function placed(wanted: readonly Wanted[], room: Room, before: ReadonlyMap<string, number>): Placed[] {
  const found: Placed[] = [];
  for (const label of wanted) {
    let best: Placed | null = null;
    let least = Infinity;
    for (const further of label.inside ? FURTHER : [0]) {
      for (const turn of TURNS) {
        const one = laid(label, turn, further);
        const dear = PER_PIXEL * further + Math.abs(turn) - (before.get(label.key) === turn ? 0.3 : 0);
        const cost = dear + costOf(one.box, label, room, found);
        if (cost < least) [best, least] = [one, cost];
      }
    }
    if (best !== null && (least <= TOO_DEAR || !label.optional)) found.push(best);
  }
  return found;
}

function laid(label: Wanted, turn: number, further: number): Placed {
  const angle = label.angle + turn;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const off = label.off + further;
  const x = label.end[0] + off * cos;
  const middle = label.end[1] - off * sin - (sin * label.height) / 2;
  const anchor = cos > ANCHORED ? "start" : cos < -ANCHORED ? "end" : "middle";
  const left = anchor === "start" ? x : anchor === "end" ? x - label.width : x - label.width / 2;
  const top = middle - label.height / 2;
  return {
    key: label.key, at: [x, top], anchor, turn,
    box: { left, top, right: left + label.width, bottom: top + label.height },
  };
}

function costOf(box: Box, { inside }: Wanted, room: Room, others: readonly Placed[]): number {
  let cost = 0;
  const wide = { left: box.left - 8, right: box.right + 8, top: box.top - 2, bottom: box.bottom + 2 };
  for (const other of others) if (overlap(wide, other.box)) cost += 100;
  for (const kept of room.kept) if (overlap(box, kept)) cost += 100;
  if (overlap(box, room.hull)) cost += inside ? OVER_OWN_HULL : OVER_HULL;
  if (inside) for (const [from, to] of room.sides) if (crosses(from, to, box)) cost += OVER_SIDE;
  for (const [from, to] of room.arrows) if (crosses(from, to, box)) cost += 60;
  if (box.left < 4 || box.top < 4 || box.right > room.width - 4 || box.bottom > room.height - 4) cost += 50;
  return cost;
}

export function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/** Whether a line enters a box. */
export function crosses([x0, y0]: Pair, [x1, y1]: Pair, box: Box): boolean {
  let [from, to] = [0, 1];
  const sides: [number, number][] = [
    [x0 - x1, x0 - box.left], [x1 - x0, box.right - x0],
    [y0 - y1, y0 - box.top], [y1 - y0, box.bottom - y0],
  ];
  for (const [slope, room] of sides) {
    if (slope === 0) {
      if (room < 0) return false;
    } else if (slope < 0) from = Math.max(from, room / slope);
    else to = Math.min(to, room / slope);
  }
  return from <= to;
}
