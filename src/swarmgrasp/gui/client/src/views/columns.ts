/* The landscape's measures: a column for each piece, degrees off square up, names below. No DOM. */

import type { LandscapePiece, ProblemData } from "../messages";
import { folded, type Shape } from "../plan/shape";

const DEGREE = Math.PI / 180;
const RANGES = [35, 65, 90, 180];
const LEAST_WIDTH = 18;
const GAP = 5;
/** Half the height of a direction without choice [rad]. */
export const ALONE = 2 * DEGREE;
/** From so many pieces on, those that touch are drawn as one. */
const MANY = 12;

export interface Axis {
  /** Of the picture, either way off square [rad]. */
  readonly range: number;
  /** Where lines and figures stand [rad]. */
  readonly ticks: readonly number[];
}

export interface Column {
  readonly piece: LandscapePiece;
  readonly edge: number;
  readonly left: number;
  readonly width: number;
  /** Off square into the hull, or out of it [rad], one for each row. */
  readonly off: readonly number[];
  /** Half the height of a row that stands alone [rad]: what a newcomer steers that keeps its sector. */
  readonly band: number;
}

/** Off square, of a push and of a pull alike: both are square at 0. */
export function offOf(row: number): number {
  const off = folded(row);
  return Math.abs(off) <= Math.PI / 2 + 1e-9 ? off : folded(off - Math.PI);
}

/** Whether a piece may be taken in all directions, so that its rows are more than half a turn. */
export function isFree(piece: LandscapePiece): boolean {
  const { rows } = piece;
  return rows.length > 1 && Math.abs(rows[rows.length - 1]! - rows[0]!) > Math.PI + 1e-6;
}

export function axisOf(columns: readonly Column[]): Axis {
  const free = columns.some(({ piece }) => isFree(piece));
  const most = Math.max(0, ...columns.flatMap(({ piece, band }) => ends(piece).map((row) =>
    Math.abs(free ? folded(row) : offOf(row)) + (piece.rows.length === 1 && band > ALONE ? band : 0))));
  const degrees = free ? 180 : RANGES.find((range) => most <= range * DEGREE + 1e-9) ?? 180;
  const step = degrees > 90 ? 90 : degrees > 65 ? 45 : degrees > 35 ? 30 : 15;
  const ticks = [];
  for (let tick = -Math.floor(degrees / step) * step; tick <= degrees; tick += step) ticks.push(tick * DEGREE);
  return { range: degrees * DEGREE, ticks };
}

function ends({ rows }: LandscapePiece): number[] {
  return rows.length === 0 ? [] : [rows[0]!, rows[rows.length - 1]!];
}

/** The edge that a piece lies on; of a corner the one that is named. */
export function edgeOf({ edge: name, start, end }: LandscapePiece, shape: Shape): number {
  const edge = shape.edgeAt((start + end) / 2);
  const before = (edge + shape.vertices.length - 1) % shape.vertices.length;
  const isNamed = (index: number): boolean => name === (shape.names[index] || `edge ${index}`);
  const atCorner = end === start && Math.abs(shape.wrapped(start) - shape.starts[edge]!) < 1e-6 * shape.perimeter;
  return atCorner && !isNamed(edge) && isNamed(before) ? before : edge;
}

/** How far either side of square a newcomer pushes on a piece that keeps its whole sector there [rad]. */
export function sectorOn({ newcomer, zones }: ProblemData, piece: LandscapePiece): number {
  if (newcomer.friction !== null) return Math.atan(newcomer.friction);
  if (!newcomer.steers) return ALONE;
  const zone = zones?.find(({ name }) => name === piece.name);
  return zone?.half_angle ?? newcomer.half_angle ?? (newcomer.attachment === "free" ? Math.PI : Math.PI / 2);
}

/** Columns side by side, as they stand round the outline: all wide enough to hit, and longer pieces wider. */
export function columnsOf(
  pieces: readonly LandscapePiece[], shape: Shape, left: number, width: number, bandOf: (piece: LandscapePiece) => number = () => ALONE,
): Column[] {
  const sorted = [...pieces].sort((a, b) => a.start - b.start);
  const gaps = sorted.map((piece, i) => gapAfter(piece, sorted[i + 1], sorted.length));
  const squeezed = Math.min(1, width / 3 / Math.max(1e-9, sum(gaps)));
  const room = width - squeezed * sum(gaps);
  const base = Math.min(LEAST_WIDTH, (room / 2) / sorted.length);
  const total = sum(sorted.map((piece) => piece.end - piece.start));
  const spare = room - base * sorted.length;
  const free = sorted.some(isFree);
  let at = left;
  return sorted.map((piece, i) => {
    const wide = base + spare * (total > 0 ? (piece.end - piece.start) / total : 1 / sorted.length);
    const off = piece.rows.map((row) => (free ? folded(row) : offOf(row)));
    const column = { piece, edge: edgeOf(piece, shape), left: at, width: wide, off, band: bandOf(piece) };
    at += wide + squeezed * gaps[i]!;
    return column;
  });
}

/** Of a round side many short pieces follow each other: these stand without gaps. */
function gapAfter(piece: LandscapePiece, next: LandscapePiece | undefined, many: number): number {
  if (next === undefined) return 0;
  return many > MANY && Math.abs(next.start - piece.end) < 1e-6 * Math.max(1, piece.end) ? 0 : GAP;
}

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0);
}

/**
 * The value at a place within a column (0 to 1 along it) and off square, in steps; null where
 * nothing is allowed. Between cells it is interpolated.
 */
export function valueAt(column: Column, values: ArrayLike<number>, along: number, off: number): number | null {
  const { piece: { columns, first }, off: rows } = column;
  const row = position(column, off);
  if (row === null) return null;
  const at = along * (columns.length - 1);
  const [i, j] = [Math.floor(at), Math.floor(row)];
  const [u, v] = [at - i, row - j];
  const cell = (a: number, b: number): number =>
    values[first + Math.min(a, columns.length - 1) * rows.length + Math.min(b, rows.length - 1)]!;
  const corners = [cell(i, j), cell(i + 1, j), cell(i, j + 1), cell(i + 1, j + 1)] as const;
  if (corners.some((value) => value === 0)) {
    const nearest = cell(Math.round(at), Math.round(row));
    return nearest === 0 ? null : nearest - 1;
  }
  const [low, high] = [corners[0] + u * (corners[1] - corners[0]), corners[2] + u * (corners[3] - corners[2])];
  return low + v * (high - low) - 1;
}

/**
 * `valueAt` for every pixel of a column, one row of pixels after the other from above; -1 where
 * nothing is allowed. `range` is how far off square its upper rim is [rad].
 */
export function pixelsOf(column: Column, values: ArrayLike<number>, wide: number, high: number, range: number): Float32Array {
  const { piece: { columns: { length }, first }, off: rows } = column;
  const found = new Float32Array(wide * high).fill(-1);
  const at = Float64Array.from({ length: wide }, (_, x) => (wide < 2 ? 0 : (x / (wide - 1)) * (length - 1)));
  let pixel = 0;
  for (let y = 0; y < high; y++) {
    const row = position(column, range * (1 - (2 * (y + 0.5)) / high));
    if (row === null) {
      pixel += wide;
      continue;
    }
    const below = Math.floor(row);
    const above = Math.min(below + 1, rows.length - 1);
    const v = row - below;
    for (let x = 0; x < wide; x++) {
      const left = Math.floor(at[x]!);
      const u = at[x]! - left;
      const from = first + left * rows.length;
      const to = left + 1 < length ? from + rows.length : from;
      const a = values[from + below]!;
      const b = values[to + below]!;
      const c = values[from + above]!;
      const d = values[to + above]!;
      const low = a + u * (b - a);
      const nearest = u < 0.5 ? (v < 0.5 ? a : c) : v < 0.5 ? b : d;
      found[pixel++] = (a * b * c * d === 0 ? nearest : low + v * (c + u * (d - c) - low)) - 1;
    }
  }
  return found;
}

/** The place of an angle among rows that rise evenly; null beyond them. */
function position({ off: rows, band }: Column, off: number): number | null {
  const [low, high] = [rows[0]!, rows[rows.length - 1]!];
  if (rows.length === 1) return Math.abs(off - low) <= band + 1e-9 ? 0 : null;
  if (off < low - 1e-9 || off > high + 1e-9) return null;
  return Math.max(0, Math.min(rows.length - 1, ((off - low) / (high - low)) * (rows.length - 1)));
}

const KINDS = /^(bollards?|pads?|fairleads?|chocks?|cleats?|sides?|places?)$/;

/** A name short enough to stand under a column: what kind of place it is goes without saying. */
export function shortName(name: string): string {
  const words = name.split(/\s+/).map((word) => (word === "starboard" ? "stbd" : word));
  const kept = words.filter((word) => !KINDS.test(word));
  return (kept.length > 0 ? kept : words).join(" ");
}

export interface Named {
  readonly text: string;
  /** Its middle. */
  readonly x: number;
  readonly column: number;
}

/** Names that do not touch each other, the first column of `before` others first. */
export function namesOf(
  columns: readonly Column[], first: number, measure: (text: string) => number, left: number, right: number,
): Named[] {
  const order = columns.map((_, i) => i).sort((a, b) => Number(b === first) - Number(a === first) || a - b);
  const placed: { from: number; to: number; named: Named }[] = [];
  for (const i of order) {
    const column = columns[i]!;
    const text = shortName(column.piece.name);
    if (text === "" || placed.some(({ named }) => named.text === text)) continue;
    const half = measure(text) / 2;
    const x = Math.max(left + half, Math.min(right - half, column.left + column.width / 2));
    const [from, to] = [x - half - 6, x + half + 6];
    if (2 * half > right - left || placed.some((other) => from < other.to && to > other.from)) continue;
    placed.push({ from, to, named: { text, x, column: i } });
  }
  return placed.map(({ named }) => named);
}
