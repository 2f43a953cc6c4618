/* Wind held from every bearing, bow up. The wind that is asked about is a handle. */

import { WIND } from "../bar";
import type { Context, Seen, View } from "../context";
import { el, Pool, put, show, svg, write } from "../dom";
import type { Tile } from "../layout";
import type { CapabilityPart, Doc, Pair } from "../messages";
import { figure, type Speech } from "../speech";
import { whenLooksChange } from "./paint";
import { calmRim, curve, freeBearing, polar, rimOf, speedAt, type Point, type Rim } from "./polar";

const TURN = 2 * Math.PI;
const DEGREE = Math.PI / 180;
/** Room for the bearings round the rim: sideways and above. */
const [SIDE, ABOVE] = [38, 22];
const HULL = 32;

interface Wind {
  readonly speed: number;
  readonly bearing: number;
}

export class Rose implements View {
  readonly #tile: Tile;
  readonly #context: Context;
  readonly #nodes;
  readonly #keys: Pool<HTMLElement, readonly [string, string]>;
  readonly #rings: Pool<SVGCircleElement, number>;
  readonly #figures: Pool<SVGTextElement, number>;
  readonly #bearings: Pool<SVGTextElement, number>;
  #rim: Rim | null = null;
  #free: number | null = null;
  /** Pixels per m/s. */
  #scale = 1;
  #seen: Seen | null = null;
  #drawn: readonly unknown[] = [];

  constructor(tile: Tile, context: Context) {
    this.#tile = tile;
    this.#context = context;
    const nodes = makeNodes();
    this.#nodes = nodes;
    tile.body.append(nodes.svg, nodes.why);
    this.#keys = new Pool(tile.aside, makeKey, dressKey);
    this.#rings = new Pool(nodes.rings, () => svg("circle"), (node, r: number) => put(node, { r }));
    this.#figures = new Pool(nodes.figures, () => svg("text"), () => undefined);
    this.#bearings = new Pool(nodes.around, () => svg("text"), () => undefined);
    tile.aside.classList.add("keys");
    this.#takeInHand();
    whenLooksChange(context.root, tile.body, () => {
      this.#drawn = [];
      if (this.#seen !== null) this.draw(this.#seen);
    });
  }

  draw(seen: Seen): void {
    this.#seen = seen;
    const { capability } = seen.parts;
    const { environment, in_weather, problem } = seen.doc;
    const speech = this.#context.speech.value;
    const inputs = [
      capability, environment, in_weather, problem.swarm.outline, problem.criterion, speech,
      seen.empty.capability, seen.parts.answer?.first.good,
    ];
    if (inputs.every((input, i) => input === this.#drawn[i])) return;
    this.#drawn = inputs;
    const none = capability === undefined;
    write(this.#nodes.why, none ? seen.empty.capability ?? "" : "");
    show(this.#nodes.svg, !none);
    show(this.#tile.aside, !none);
    if (none) return;
    this.#drawRose(capability, seen, speech);
  }

  #drawRose(capability: CapabilityPart, seen: Seen, speech: Speech): void {
    const { clientWidth: width, clientHeight: height } = this.#tile.body;
    const radius = Math.max(20, Math.min(width / 2 - SIDE, height / 2 - ABOVE));
    const wind = windOf(seen.doc);
    const losing = isLosing(seen.doc);
    const unit = speech.data.speed.size;
    const asked = seen.doc.in_weather ? wind.speed : 0;
    const reach = { intact: [...capability.intact], lost: losing ? [...capability.lost] : [], wind: asked };
    const now = rimOf(reach, unit);
    this.#rim = calmRim(this.#rim, now, asked, now.rim);
    const { rim, step } = this.#rim;
    this.#scale = radius / rim;
    const nodes = this.#nodes;
    put(nodes.svg, { viewBox: `${-width / 2} ${-height / 2} ${width} ${height}`, width, height });
    this.#drawRings(radius, rim, step);
    const path = (speeds: Float32Array): string => curve(capability.bearings, speeds, this.#scale, rim);
    const before = losing ? capability.before_lost : capability.before_intact;
    put(nodes.intact, { d: path(capability.intact) });
    put(nodes.lost, { d: losing ? path(capability.lost) : "" });
    put(nodes.before, { d: before === undefined ? "" : path(before) });
    this.#drawHull(seen.doc.problem.swarm.outline.vertices);
    const least = polar(capability.least.bearing, Math.min(capability.least.speed, rim) * this.#scale);
    put(nodes.least, { cx: least[0], cy: least[1], "data-intact": !losing });
    const dot = this.#drawWind(wind, seen, radius);
    const shown = [capability.intact, ...(losing ? [capability.lost] : []), ...(before === undefined ? [] : [before])];
    const line = [0, 1, 2, 3, 4, 5, 6].map((k) => polar(wind.bearing, wind.speed * this.#scale + 12 * k));
    const points = this.#marks(capability.bearings, shown, [least, dot, ...line]);
    this.#drawFigures(points, rim, step, speech);
    this.#drawBearings(radius, speech);
    this.#keys.draw(keysOf(seen.doc, losing, before !== undefined));
    this.#describe(capability, wind, seen, speech);
  }

  #drawRings(radius: number, rim: number, step: number): void {
    const rings = [];
    for (let speed = step; speed < rim - step / 2; speed += step) rings.push(speed * this.#scale);
    this.#rings.draw([...rings, radius]);
    const ticks = [];
    for (let k = 0; k < 12; k++) {
      const [a, b] = [polar(k * 30 * DEGREE, radius), polar(k * 30 * DEGREE, radius + 4)];
      ticks.push(`M${a[0]} ${a[1]}L${b[0]} ${b[1]}`);
    }
    put(this.#nodes.ticks, { d: ticks.join("") });
  }

  #drawHull(vertices: readonly Pair[]): void {
    const xs = vertices.map(([x]) => x);
    const ys = vertices.map(([, y]) => y);
    const span = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
    const [cx, cy] = [(Math.max(...xs) + Math.min(...xs)) / 2, (Math.max(...ys) + Math.min(...ys)) / 2];
    const scale = HULL / Math.max(span, 1e-9);
    const points = vertices.map(([x, y]) => `${(-(y - cy) * scale).toFixed(1)},${(-(x - cx) * scale).toFixed(1)}`);
    put(this.#nodes.hull, { points: points.join(" ") });
  }

  /** The wind's dot and the line along which it comes. */
  #drawWind(wind: Wind, seen: Seen, radius: number): Point {
    const rim = this.#rim!.rim;
    const dot = polar(wind.bearing, Math.min(wind.speed, rim) * this.#scale);
    const outside = polar(wind.bearing, radius);
    const nodes = this.#nodes;
    put(nodes.from, { x1: outside[0], y1: outside[1], x2: dot[0], y2: dot[1] });
    put(nodes.wind, {
      transform: `translate(${dot[0].toFixed(2)} ${dot[1].toFixed(2)})`,
      "data-off": !seen.doc.in_weather,
    });
    put(nodes.from, { "data-off": !seen.doc.in_weather });
    return dot;
  }

  /** What figures keep away from: the curves, and a few points. */
  #marks(bearings: Float32Array, curves: readonly Float32Array[], points: readonly Point[]): Point[] {
    const found = [...points];
    for (const speeds of curves) {
      speeds.forEach((speed, i) => {
        if (Number.isFinite(speed)) found.push(polar(bearings[i]!, Math.min(speed, this.#rim!.rim) * this.#scale));
      });
    }
    return found;
  }

  #drawFigures(points: readonly Point[], rim: number, step: number, speech: Speech): void {
    const speeds: number[] = [];
    for (let speed = step; speed <= rim + step / 2; speed += step) speeds.push(speed);
    this.#free = freeBearing(speeds.map((speed) => speed * this.#scale), points, this.#free);
    this.#figures.draw(speeds);
    this.#figures.nodes.forEach((node, i) => {
      const [x, y] = polar(this.#free!, speeds[i]! * this.#scale);
      put(node, { x: x.toFixed(1), y: (y + 4).toFixed(1) });
      write(node, figure(Math.round(speeds[i]! / speech.data.speed.size)));
    });
  }

  #drawBearings(radius: number, speech: Speech): void {
    const quarters = [0, 1, 2, 3];
    this.#bearings.draw(quarters);
    this.#bearings.nodes.forEach((node, k) => {
      const [x, y] = polar(k * 90 * DEGREE, radius + (k % 2 === 0 ? 12 : 8));
      put(node, {
        x, y: k % 2 === 0 ? y + (k === 0 ? 2 : 6) : y + 4,
        "text-anchor": (["middle", "start", "middle", "end"] as const)[k]!,
      });
      write(node, speech.bearing(k * 90 * DEGREE).slice(0, -1));
    });
  }

  #describe(capability: CapabilityPart, wind: Wind, seen: Seen, speech: Speech): void {
    const { bearing, speed } = capability.least;
    const most = speedAt(capability.bearings, isLosing(seen.doc) ? capability.lost : capability.intact, wind.bearing);
    const held = Number.isFinite(most) ? `; held from there up to ${speech.speed(most)}` : "";
    const unit = speech.data.speed;
    put(this.#nodes.svg, {
      "aria-label": `Wind held from every bearing; the least is ${speech.speed(speed)} from ${speech.bearing(bearing)}`,
    });
    put(this.#nodes.wind, {
      "aria-valuenow": Math.round(wind.speed / unit.size), "aria-valuemin": 0,
      "aria-valuemax": Math.round(this.#rim!.rim / unit.size),
      "aria-valuetext": `${speech.speed(wind.speed)} from ${speech.bearing(wind.bearing)}`
        + `${seen.doc.in_weather ? "" : ", not asked about"}${held}`,
    });
  }

  /** Drag, or arrows: across turns the bearing, up and down changes the speed. */
  #takeInHand(): void {
    const { store } = this.#context;
    const { svg: area, wind: handle } = this.#nodes;
    const follow = (event: PointerEvent): void => {
      const box = area.getBoundingClientRect();
      const x = event.clientX - box.left - box.width / 2;
      const y = event.clientY - box.top - box.height / 2;
      const unit = this.#context.speech.value.data.speed.size;
      const speed = Math.round(Math.hypot(x, y) / this.#scale / unit) * unit;
      const bearing = Math.round(Math.atan2(x, -y) / DEGREE) * DEGREE;
      this.#set({ speed, bearing: ((bearing % TURN) + TURN) % TURN }, true);
    };
    handle.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener("pointermove", (event) => {
      if (handle.hasPointerCapture(event.pointerId)) follow(event);
    });
    handle.addEventListener("lostpointercapture", () => store.settle());
    handle.addEventListener("keydown", (event) => this.#key(event));
  }

  #key(event: KeyboardEvent): void {
    const seen = this.#context.store.seen.value;
    if (seen === null || event.altKey || event.ctrlKey || event.metaKey) return;
    const wind = windOf(seen.doc);
    const size = event.shiftKey ? 10 : 1;
    const turn = { ArrowLeft: -1, ArrowRight: 1 }[event.key] ?? 0;
    const more = { ArrowDown: -1, ArrowUp: 1, PageDown: -10, PageUp: 10 }[event.key] ?? 0;
    if (turn === 0 && more === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const unit = this.#context.speech.value.data.speed.size;
    const bearing = (Math.round(wind.bearing / DEGREE) + turn * size) * DEGREE;
    const speed = Math.max(0, Math.round(wind.speed / unit) + more * size) * unit;
    this.#set({ speed, bearing: ((bearing % TURN) + TURN) % TURN }, false);
  }

  #set(wind: Wind, moving: boolean): void {
    this.#context.store.edit((doc) => withWind(doc, wind), moving);
  }
}

/** The wind of a document, or the one that would be asked about first. */
function windOf(doc: Doc): Wind {
  const wind = doc.environment?.wind;
  return { speed: wind?.speed ?? WIND.speed, bearing: wind?.bearing ?? WIND.bearing };
}

/** The same with another wind, which is then asked about. */
export function withWind(doc: Doc, { speed, bearing }: Wind): Doc {
  const { environment } = doc;
  if (environment === null) return doc;
  return { ...doc, in_weather: true, environment: { ...environment, wind: { ...environment.wind, speed, bearing } } };
}

/** Whether what is asked is asked after a loss. */
function isLosing({ problem: { criterion } }: Doc): boolean {
  return criterion.losing > 0 || criterion.failures.length > 0;
}

function makeNodes() {
  const area = svg("svg", { class: "rose", role: "group" });
  const nodes = {
    svg: area,
    why: el("p", { class: "why" }),
    rings: svg("g", { class: "rings" }),
    ticks: svg("path", { class: "ticks" }),
    intact: svg("path", { class: "intact" }),
    lost: svg("path", { class: "lost" }),
    before: svg("path", { class: "before" }),
    hull: svg("polygon", { class: "rose-hull" }),
    figures: svg("g", { class: "figures" }),
    around: svg("g", { class: "around" }),
    least: svg("circle", { class: "least", r: 3 }),
    from: svg("line", { class: "from" }),
    wind: svg("g", { class: "rose-wind", role: "slider", tabindex: 0, "aria-label": "Wind" },
      svg("circle", { class: "rose-grab", r: 16 }), svg("circle", { class: "rose-dot", r: 6 })),
  };
  area.append(
    nodes.rings, nodes.ticks, nodes.hull, nodes.intact, nodes.lost, nodes.before, nodes.figures,
    nodes.around, nodes.least, nodes.from, nodes.wind,
  );
  return nodes;
}

function keysOf(doc: Doc, losing: boolean, before: boolean): (readonly [string, string])[] {
  const { losing: k, failures } = doc.problem.criterion;
  const lost = failures.length > 0 ? "after a loss" : k === 1 ? "one lost" : `${k} lost`;
  return [
    ["intact", "all"],
    ...(losing ? [["lost", lost] as const] : []),
    ...(before ? [["before", "before"] as const] : []),
  ];
}

function makeKey(): HTMLElement {
  return el("span", { class: "key" }, el("span", { class: "swatch" }), el("span"));
}

function dressKey(node: HTMLElement, [mark, word]: readonly [string, string]): void {
  put(node, { "data-mark": mark });
  write(node.lastElementChild!, word);
}
