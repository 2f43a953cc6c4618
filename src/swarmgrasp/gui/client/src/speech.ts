/* Numbers for people: in the file's units and frame. A number and its unit are joined by U+00A0. */

import type { Pair, SpeechData, UnitData } from "./messages";

/** Of wind, current or waves: what is changed in the page. */
export type BlowData = { speed: number | null; bearing: number | null };

const SPACE = "\u00a0";
const MINUS = "\u2212";
const TURN = 2 * Math.PI;

/** One decimal below 9.95, else whole; grouped from 10 000 on. */
export function figure(value: number, digits?: number): string {
  const size = Math.abs(value);
  const places = digits ?? (size >= 9.95 || size < 1e-9 ? 0 : size < 0.0995 ? 3 : size < 0.995 ? 2 : 1);
  let text = size.toFixed(places);
  if (size >= 1e4) text = text.replace(/\B(?=(\d{3})+(?!\d))/g, SPACE);
  return (value < 0 && Number(text.replaceAll(SPACE, "")) !== 0 ? MINUS : "") + text;
}

export function signed(value: number, digits = 0): string {
  const text = figure(value, digits);
  return value > 0 && Number(value.toFixed(digits)) !== 0 ? `+${text}` : text;
}

export class Speech {
  readonly data: SpeechData;

  constructor(data: SpeechData) {
    this.data = data;
  }

  /** What one robot is called: "tug". */
  get robot(): string {
    return this.data.robot;
  }

  /** The same at the start of a sentence. */
  get Robot(): string {
    return this.robot.charAt(0).toUpperCase() + this.robot.slice(1);
  }

  length(metres: number, digits = 1): string {
    return this.#text(metres, this.data.length, digits);
  }

  force(newtons: number): string {
    return this.#text(newtons, this.forceUnit(newtons));
  }

  /** A force without its unit, in the one that fits `largest`. */
  forceFigure(newtons: number, largest = newtons): string {
    return figure(newtons / this.forceUnit(largest).size);
  }

  /** The unit for forces as large as this: that of the file, and N with a prefix that suits. */
  forceUnit(newtons: number): UnitData {
    const { force } = this.data;
    const size = Math.abs(newtons);
    if (force.unit !== "N" || size < 1e4) return force;
    return size < 1e7 ? { unit: "kN", size: 1e3, label: "kN" } : { unit: "MN", size: 1e6, label: "MN" };
  }

  speed(metresASecond: number): string {
    return this.#text(metresASecond, this.data.speed);
  }

  /** Degrees off square and the like, with a sign. */
  angle(radians: number): string {
    return `${signed((radians * 180) / Math.PI)}°`;
  }

  /** Where something comes from or leads, clockwise from the bow, or from north with a heading. */
  bearing(clockwise: number): string {
    const degrees = Math.round((this.told(clockwise) * 180) / Math.PI) % 360;
    return `${String(degrees).padStart(3, "0")}°`;
  }

  /** The bearing of a direction, which is counter-clockwise from the bow. */
  bearingOf(direction: number): string {
    return this.bearing(-direction);
  }

  /** A bearing from the bow, as it is told; within one turn. */
  told(clockwise: number): number {
    return (((clockwise + (this.data.heading ?? 0)) % TURN) + TURN) % TURN;
  }

  /** A bearing from the bow, of one as it is told. */
  untold(bearing: number): number {
    return bearing - (this.data.heading ?? 0);
  }

  /** A point of ours in the file's frame and unit. */
  point(at: Pair, digits = 1): string {
    const [x, y] = this.toFile(at);
    return `${figure(x, digits)}, ${figure(y, digits)}${SPACE}${this.data.length.label}`;
  }

  toFile([x, y]: Pair): Pair {
    const side = this.data.mirrored ? -1 : 1;
    const [cos, sin] = [Math.cos(this.data.bow), Math.sin(this.data.bow)];
    const { size } = this.data.length;
    return [(cos * x - side * sin * y) / size, (sin * x + side * cos * y) / size];
  }

  fromFile([x, y]: Pair): Pair {
    const side = this.data.mirrored ? -1 : 1;
    const [cos, sin] = [Math.cos(this.data.bow), Math.sin(this.data.bow)];
    const { size } = this.data.length;
    return [(cos * x + sin * y) * size, side * (cos * y - sin * x) * size];
  }

  #text(value: number, unit: UnitData, digits?: number): string {
    return `${figure(value / unit.size, digits)}${SPACE}${unit.label}`;
  }
}

/** Before there is a scene: SI, our frame. */
export const SILENT: SpeechData = {
  length: { unit: "m", size: 1, label: "m" }, force: { unit: "N", size: 1, label: "N" },
  angle: { unit: "deg", size: Math.PI / 180, label: "°" }, speed: { unit: "m/s", size: 1, label: "m/s" },
  torque_unit: "N m", robot: "robot", bow: 0, mirrored: false, heading: null, bearings: false,
};
