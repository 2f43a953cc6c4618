/* Robots, the newcomer and its next best places, each a thing to take in hand. */

import { Pool, put, svg } from "../dom";
import type { NextPlace, Pair, RobotData } from "../messages";
import { arcPath, arrow, figureOf, type Figure } from "./figures";
import type { Stage } from "./stage";
import { path } from "./screen";
import { alongEdge, stanceWords } from "./stance";

interface Parts {
  readonly reach: SVGPathElement;
  readonly grab: SVGPathElement;
  readonly shaft: SVGPathElement;
  readonly head: SVGPathElement;
  readonly tail: SVGPathElement;
  readonly ring: SVGCircleElement;
  readonly contact: SVGCircleElement;
}

function parts(group: SVGGElement): Parts {
  const made: Parts = {
    reach: svg("path", { class: "reach" }),
    grab: svg("path", { class: "grab" }),
    shaft: svg("path", { class: "shaft" }),
    head: svg("path", { class: "head" }),
    tail: svg("path", { class: "head" }),
    ring: svg("circle", { class: "ring", r: 11 }),
    contact: svg("circle", { class: "foot" }),
  };
  group.append(made.reach, made.grab, made.shaft, made.head, made.tail, made.ring, made.contact);
  return made;
}

export class RobotLayer {
  readonly group = svg("g", { class: "layer-robots" });
  readonly #parts = new WeakMap<SVGGElement, Parts>();
  readonly #robots: Pool<SVGGElement, Figure>;
  #stage: Stage | null = null;

  constructor() {
    this.#robots = new Pool(this.group, () => {
      const group = svg("g", { class: "robot", role: "slider" });
      this.#parts.set(group, parts(group));
      return group;
    }, (group, figure) => this.#dress(group, figure));
  }

  draw(stage: Stage): void {
    this.#stage = stage;
    this.#robots.draw(stage.figures);
  }

  /** The element of a robot, to give it the focus. */
  of(name: string): SVGGElement | undefined {
    return this.#robots.nodes.find((node) => node.dataset.robot === name);
  }

  #dress(group: SVGGElement, figure: Figure): void {
    const { seen, shape, speech, lost, hovered, scale } = this.#stage!;
    const { robot, stance } = figure;
    const chosen = seen.chosen === robot.name;
    const first = this.#stage!.figures[0]?.robot.name === robot.name;
    const classes = ["robot"];
    if (chosen) classes.push("chosen");
    else if (seen.chosen !== null && seen.mode === "move") classes.push("other");
    if (lost.has(robot.name)) classes.push("lost");
    if (hovered?.kind === "robot" && hovered.name === robot.name) classes.push("hovered");
    if (seen.mode === "push") classes.push("pushing");
    const along = stance === null ? 0 : alongEdge(shape, stance) / speech.data.length.size;
    put(group, {
      class: classes.join(" "), "data-robot": robot.name,
      tabindex: chosen || (seen.chosen === null && first) ? 0 : -1,
      "aria-label": robot.name || "unnamed",
      "aria-roledescription": speech.robot,
      "aria-valuenow": along.toFixed(2), "aria-valuemin": 0,
      "aria-valuemax": stance === null ? null : (shape.lengthOf(stance.edge) / speech.data.length.size).toFixed(2),
      "aria-valuetext": stanceWords(shape, robot, speech),
    });
    const share = seen.forces?.robots.find(({ name }) => name === robot.name)?.share ?? null;
    dressFigure(this.#parts.get(group)!, figure, scale.many ? 3.2 : 4.5, seen.mode === "push" ? share ?? 0 : null);
  }
}

/** Draws an arrow, what it can exert and its contact; with a share, only so much in colour. */
function dressFigure(made: Parts, figure: Figure, radius: number, share: number | null): void {
  const { from, to, contact, width, round, robot } = figure;
  put(made.reach, { d: figure.reach.join("") });
  put(made.grab, { d: path([contact, figure.free]) });
  put(made.contact, { cx: contact[0], cy: contact[1], r: radius });
  put(made.ring, { cx: contact[0], cy: contact[1] });
  const whole = arrow(from, to, width);
  if (share !== null) {
    const full = path([from, to]);
    const part = figure.stance?.pushes === true ? [blend(to, from, share), to] : [from, blend(from, to, share)];
    const used = arrow(part[0]!, part[1]!, width);
    put(made.reach, { d: full });
    put(made.shaft, { d: share > 0.01 ? used.shaft : "" });
    put(made.head, { d: share > 0.01 ? used.head : "" });
    put(made.tail, { d: "" });
    return;
  }
  put(made.shaft, { d: round ? "" : whole.shaft, "stroke-width": width });
  put(made.head, { d: round ? "" : whole.head });
  put(made.tail, { d: robot.reverse_limit > 0 && !round ? arrow(to, from, width).head : "" });
}

function blend(from: Pair, to: Pair, share: number): Pair {
  return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
}

export const FAN_RADIUS = 92;

/** The newcomer at its best place, what it may do there, and where else it might go. */
export class NewcomerLayer {
  readonly group = svg("g", { class: "layer-new" });
  readonly #next: Pool<SVGCircleElement, NextPlace>;
  readonly #fan = svg("path", { class: "fan" });
  readonly #sides = svg("path", { class: "fan-sides" });
  readonly #halo = svg("circle", { class: "halo", r: 15 });
  readonly #body = svg("g", { class: "newcomer", role: "button", tabindex: 0 });
  readonly #parts = parts(this.#body);
  readonly #ghost = svg("g", { class: "ghost" });
  readonly #ghostParts = parts(this.#ghost);
  readonly #later: Pool<SVGGElement, Figure>;
  readonly #laterParts = new WeakMap<SVGGElement, Parts>();
  #stage: Stage | null = null;

  constructor() {
    const next = svg("g", { class: "runners-up" });
    const later = svg("g", { class: "later" });
    this.group.append(this.#fan, this.#sides, next, later, this.#halo, this.#body, this.#ghost);
    this.#next = new Pool(next, () => svg("circle", { class: "runner-up", r: 5 }), (node, place) => {
      const [cx, cy] = this.#stage!.screen.at(place.contact);
      put(node, { cx, cy });
    });
    this.#later = new Pool(later, () => {
      const group = svg("g", { class: "newcomer later" });
      this.#laterParts.set(group, parts(group));
      return group;
    }, (group, figure) => dressFigure(this.#laterParts.get(group)!, figure, 5, null));
  }

  /** @param later newcomers after the first, where they would go. */
  draw(stage: Stage, later: readonly RobotData[]): void {
    this.#stage = stage;
    const { seen, newcomer, shape, screen, speech, scale, hovered } = stage;
    const answer = seen.parts.answer;
    const stays = seen.mode !== "push" && newcomer !== null;
    const good = seen.doc.newcomer && seen.mode !== "push"
      ? (answer?.next ?? []).filter((place) => place.share > 0.5) : [];
    this.#next.draw(good);
    this.#later.draw(stays ? later.map((robot) => figureOf(robot, true, shape, screen, scale)) : []);
    put(this.#body, { hidden: newcomer === null });
    put(this.#halo, { hidden: !stays });
    if (newcomer !== null) {
      const chosen = seen.chosen === newcomer.robot.name;
      const hover = hovered?.kind === "robot" && hovered.name === newcomer.robot.name;
      const kind = seen.mode === "push" ? "newcomer away" : "newcomer";
      put(this.#body, {
        class: kind + (chosen ? " chosen" : "") + (hover ? " hovered" : ""),
        "data-robot": newcomer.robot.name, "aria-pressed": String(chosen),
        "aria-label": `${newcomer.robot.name || "newcomer"} comes ${stanceWords(shape, newcomer.robot, speech)}`,
      });
      put(this.#halo, { cx: newcomer.contact[0], cy: newcomer.contact[1] });
      dressFigure(this.#parts, newcomer, 6, null);
    }
    this.#drawFan();
    put(this.#ghost, { hidden: hovered?.kind !== "place" });
    if (hovered?.kind === "place") {
      dressFigure(this.#ghostParts, figureOf(hovered.robot, true, shape, screen, scale), 5, null);
    }
  }

  /** The sides of the fan that a chosen newcomer may push in, as points and directions. */
  fanSides(): { at: Pair; sign: number }[] {
    const range = this.#range();
    if (range === null) return [];
    const { contact } = this.#stage!.newcomer!;
    return [-1, 1].map((sign) => ({
      at: this.#stage!.screen.step(contact, range.middle + sign * range.half, FAN_RADIUS), sign,
    }));
  }

  #range(): { middle: number; half: number } | null {
    const { newcomer, seen, shape } = this.#stage!;
    if (newcomer === null || newcomer.stance === null || seen.chosen !== newcomer.robot.name) return null;
    const data = seen.doc.problem.newcomer;
    if (data.attachment === "free") return null;
    return { middle: shape.inward(newcomer.stance.edge) + Math.PI, half: data.half_angle ?? Math.PI / 2 };
  }

  #drawFan(): void {
    const range = this.#range();
    put(this.#fan, { hidden: range === null });
    put(this.#sides, { hidden: range === null });
    if (range === null) return;
    const { contact } = this.#stage!.newcomer!;
    const screen = this.#stage!.screen;
    const angle = screen.angle(range.middle);
    const [start, end] = [-1, 1].map((sign) => screen.step(contact, range.middle + sign * range.half, FAN_RADIUS)) as [Pair, Pair];
    const rim = arcPath(contact, FAN_RADIUS, angle - range.half, angle + range.half);
    put(this.#fan, { d: `${rim}L${contact[0]} ${contact[1]}Z` });
    put(this.#sides, { d: path([start, contact, end]) });
  }
}
