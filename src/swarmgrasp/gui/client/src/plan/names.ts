/* The names in the plan, each with its limit below. */

import { Pool, put, svg, write } from "../dom";
import type { Pair } from "../messages";
import type { Figure } from "./figures";
import { NAMES_ONLY } from "./figures";
import { placed, type Box, type Placed, type Room, type Wanted } from "./labels";
import { FAN_RADIUS } from "./robots";
import type { Stage } from "./stage";

const BEYOND_FAN = FAN_RADIUS + 16;

interface Label {
  readonly figure: Figure;
  readonly name: string;
  readonly below: string;
  readonly placed: Placed;
}

export class NameLayer {
  readonly group = svg("g", { class: "layer-names", "aria-hidden": "true" });
  readonly #pool: Pool<SVGGElement, Label>;
  readonly #turns = new Map<string, number>();
  readonly #widths = new Map<string, number>();
  readonly #pen: CanvasRenderingContext2D | null;
  #stage: Stage | null = null;

  constructor() {
    this.#pen = document.createElement("canvas").getContext("2d");
    this.#pool = new Pool(this.group, () => svg("g", {}, svg("text", { class: "name" }), svg("text", { class: "below" })),
      (group, label) => this.#dress(group, label));
  }

  /** @param kept boxes of what no name should cover. */
  draw(stage: Stage, later: readonly Figure[], kept: readonly Box[]): void {
    this.#stage = stage;
    const { seen, screen, shape, newcomer, figures, speech } = stage;
    const order = [
      ...figures.filter(({ robot }) => robot.name === seen.chosen),
      ...(newcomer === null || seen.mode === "push" ? [] : [newcomer, ...later]),
      ...figures.filter(({ robot }) => robot.name !== seen.chosen && stage.matters(robot.name)),
    ];
    const few = seen.doc.problem.swarm.robots.length <= NAMES_ONLY;
    const shares = new Map(seen.forces?.robots.map(({ name, share }) => [name, share]));
    const below = (figure: Figure): string => {
      const limit = speech.force(figure.robot.limit);
      const share = shares.get(figure.robot.name);
      if (seen.mode === "push" && share !== undefined) return `${Math.round(100 * share)}\u00a0% of ${limit}`;
      return few || figure.isNew || figure.robot.name === seen.chosen ? limit : "";
    };
    const words = new Map(order.map((figure) => [figure, { name: figure.robot.name || "newcomer", below: below(figure) }]));
    const wanted = order.map((figure): Wanted => {
      const { name, below: second } = words.get(figure)!;
      const chosen = seen.chosen === figure.robot.name;
      return {
        key: figure.isNew ? `new ${name}` : name, ...endOf(figure),
        width: Math.max(this.#width(name, figure.isNew ? 15 : 13, 600), this.#width(second, 12, 400)),
        height: second === "" ? 16 : 32, off: offOf(figure, chosen),
        optional: !chosen && !figure.isNew, inside: figure.robot.mounted,
      };
    });
    const corners = shape.vertices.map((corner) => screen.at(corner));
    const room: Room = {
      width: screen.width, height: screen.height, kept, hull: boxOf(corners),
      sides: corners.map((corner, i) => [corner, corners[(i + 1) % corners.length]!] as const),
      arrows: [...figures, ...(newcomer === null ? [] : [newcomer]), ...later].map(({ from, to }) => [from, to] as const),
    };
    const found = placed(wanted, room, this.#turns);
    this.#turns.clear();
    const byKey = new Map(order.map((figure) => [figure.isNew ? `new ${figure.robot.name}` : figure.robot.name, figure]));
    this.#pool.draw(found.map((one) => {
      this.#turns.set(one.key, one.turn);
      const figure = byKey.get(one.key)!;
      return { figure, placed: one, ...words.get(figure)! };
    }));
  }

  #dress(group: SVGGElement, { figure, name, below, placed: { at, anchor } }: Label): void {
    const seen = this.#stage!.seen;
    const other = seen.chosen !== null && seen.mode === "move" && seen.chosen !== name && !figure.isNew;
    put(group, { class: `label${figure.isNew ? " label-new" : ""}${other ? " other" : ""}` });
    const [first, second] = group.children as unknown as [SVGTextElement, SVGTextElement];
    put(first, { x: Math.round(at[0]), y: Math.round(at[1] + 13), "text-anchor": anchor });
    put(second, { x: Math.round(at[0]), y: Math.round(at[1] + 28), "text-anchor": anchor });
    write(first, name);
    write(second, below);
  }

  #width(text: string, size: number, weight: number): number {
    if (text === "" || this.#pen === null) return 0;
    const key = `${size} ${text}`;
    let width = this.#widths.get(key);
    if (width === undefined) {
      this.#pen.font = `${weight} ${size}px Inter, sans-serif`;
      width = this.#pen.measureText(text).width;
      if (this.#widths.size > 5000) this.#widths.clear();
      this.#widths.set(key, width);
    }
    return width;
  }
}

/** Where a name stands: beyond the free end; of one inside with a direction at its back, where it is itself. */
function endOf({ robot, round, contact, free, angle }: Figure): Pick<Wanted, "end" | "angle"> {
  return robot.mounted && !round ? { end: contact, angle: angle + Math.PI } : { end: free, angle };
}

/** Pixels from the free end: beyond the handle of one that is chosen, and beyond a newcomer's fan. */
function offOf({ isNew, free, contact }: Figure, chosen: boolean): number {
  if (!chosen) return 9;
  return isNew ? BEYOND_FAN - Math.hypot(free[0] - contact[0], free[1] - contact[1]) : 24;
}

export function boxOf(points: readonly Pair[]): Box {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
}
