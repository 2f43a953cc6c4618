/* What can be taken in hand beside the robots: turns, sectors, ends of zones, corners, the wanted wrench. */

import { Pool, put, svg } from "../dom";
import type { Pair, StretchData, ZoneData } from "../messages";
import type { Stage } from "./stage";

/** What a knob moves. */
export type Grip =
  | { readonly kind: "turn"; readonly robot: string }
  | { readonly kind: "sector"; readonly robot: string; readonly sign: number }
  | { readonly kind: "fan"; readonly sign: number }
  | { readonly kind: "zone" | "no-go"; readonly index: number; readonly end: "start" | "end" | "both" }
  | { readonly kind: "area"; readonly index: number; readonly corner: number }
  | { readonly kind: "vertex"; readonly corner: number }
  | { readonly kind: "edge"; readonly edge: number }
  | { readonly kind: "force" }
  | { readonly kind: "torque" };

export interface Knob {
  readonly grip: Grip;
  readonly at: Pair;
  readonly label: string;
  readonly value: number;
  readonly text: string;
}

export class HandleLayer {
  readonly group = svg("g", { class: "layer-handles" });
  readonly #pool: Pool<SVGGElement, Knob>;
  #knobs: readonly Knob[] = [];

  constructor() {
    this.#pool = new Pool(this.group,
      () => svg("g", { class: "knob" }, svg("circle", { class: "grab", r: 12 }), svg("circle", { class: "dot" })),
      (group, knob, index) => this.#dress(group, knob, index));
  }

  get knobs(): readonly Knob[] {
    return this.#knobs;
  }

  draw(knobs: readonly Knob[]): void {
    this.#knobs = knobs;
    this.#pool.draw(knobs);
  }

  /** The element of a knob, to give it the focus. */
  node(index: number): SVGGElement | undefined {
    return this.#pool.nodes[index];
  }

  #dress(group: SVGGElement, { grip, at, label, value, text }: Knob, index: number): void {
    const [hit, dot] = group.children as unknown as [SVGCircleElement, SVGCircleElement];
    put(group, {
      class: `knob knob-${grip.kind}`, role: grip.kind === "edge" ? "button" : "slider", tabindex: 0, "data-knob": index,
      "aria-label": label,
      ...(grip.kind === "edge" ? { "aria-valuenow": null, "aria-valuetext": null }
        : { "aria-valuenow": value.toFixed(2), "aria-valuetext": text }),
    });
    put(hit, { cx: at[0], cy: at[1] });
    put(dot, { cx: at[0], cy: at[1], r: grip.kind === "edge" ? 3.5 : grip.kind === "turn" ? 7 : 6 });
  }
}

const TURN_OFF = 11;
const SIDE_OUT = 14;
/** Ends of stretches stand outside of the hull, so that a bollard at an end can be taken, too. */
const ENDS_OFF = 16;

/** The knobs of the robot that is chosen. */
export function robotKnobs(stage: Stage): Knob[] {
  const { seen, figures, screen, speech } = stage;
  const figure = figures.find(({ robot }) => robot.name === seen.chosen);
  if (figure === undefined) return [];
  const { robot, contact, free, round } = figure;
  const knobs: Knob[] = [];
  const outward = figure.stance?.pushes === true ? robot.direction + Math.PI : robot.direction;
  if (!round) {
    const at = screen.step(free, outward, TURN_OFF);
    const off = figure.stance?.off ?? robot.direction;
    knobs.push({
      grip: { kind: "turn", robot: robot.name }, at, label: `Direction of ${robot.name}`,
      value: (off * 180) / Math.PI, text: `${speech.angle(off)} off square, towards ${speech.bearingOf(robot.direction)}`,
    });
  }
  if (robot.steers > 0 && robot.steers < Math.PI && robot.sectors === null && robot.envelope === null) {
    const far = Math.hypot(free[0] - contact[0], free[1] - contact[1]) + SIDE_OUT;
    for (const sign of [-1, 1]) {
      knobs.push({
        grip: { kind: "sector", robot: robot.name, sign }, at: screen.step(contact, outward + sign * robot.steers, far),
        label: `How far ${robot.name} steers`, value: (robot.steers * 180) / Math.PI,
        text: `${speech.angle(robot.steers).replace("+", "±")} either side`,
      });
    }
  }
  return knobs;
}

/** The knobs at the ends of zones and of what is forbidden, and at the corners of areas. */
export function zoneKnobs(stage: Stage): Knob[] {
  const { seen, speech } = stage;
  const { zones, no_go } = seen.doc.problem;
  const knobs: Knob[] = [];
  const ends = (stretch: StretchData, kind: "zone" | "no-go", index: number): void => {
    const name = stretch.name || (kind === "zone" ? `zone ${index + 1}` : `no-go ${index + 1}`);
    const point = stretch.start === stretch.end;
    for (const end of point ? (["both"] as const) : (["start", "end"] as const)) {
      const along = end === "end" ? stretch.end : stretch.start;
      const place = stage.shape.placeAt(along);
      const outward = stage.shape.inward(place.edge) + Math.PI;
      knobs.push({
        grip: { kind, index, end }, at: stage.screen.step(stage.screen.at(place.at), outward, point ? 0 : ENDS_OFF),
        label: point ? name : `${end === "start" ? "Start" : "End"} of ${name}`,
        value: along / speech.data.length.size, text: `${speech.length(along)} round the outline`,
      });
    }
  };
  zones?.forEach((zone: ZoneData, index) => {
    if (zone.stretch !== null) ends(zone.stretch, "zone", index);
    zone.area?.forEach((corner, i) => knobs.push({
      grip: { kind: "area", index, corner: i }, at: stage.screen.at(corner),
      label: `Corner ${i + 1} of ${zone.name || `zone ${index + 1}`}`, value: i + 1, text: speech.point(corner),
    }));
  });
  no_go.forEach((stretch, index) => ends(stretch, "no-go", index));
  return knobs.sort((a, b) => Number("end" in a.grip && a.grip.end !== "both") - Number("end" in b.grip && b.grip.end !== "both"));
}

/** The knobs at the corners of the outline, and one on each side that adds a corner. */
export function outlineKnobs({ shape, screen, speech }: Stage): Knob[] {
  const corners = shape.vertices.map((corner, i): Knob => ({
    grip: { kind: "vertex", corner: i }, at: screen.at(corner), label: `Corner ${i + 1} of the outline`,
    value: i + 1, text: speech.point(corner),
  }));
  const sides = shape.vertices.map((_, edge): Knob => ({
    grip: { kind: "edge", edge }, at: screen.at(shape.onEdge(edge, shape.lengthOf(edge) / 2)),
    label: `Add a corner on ${shape.nameOf(edge)}`, value: 0, text: "",
  }));
  return [...corners, ...sides];
}
