/* What a move along the outline would bring, as arrows in the plan: of the chosen robot, of all while
   zones are edited. */

import type { Context, Seen, View } from "../context";
import { Pool, put, svg, write } from "../dom";
import type { Pair, RobotData, SlopesPart } from "../messages";
import type { PlanLayer } from "../plan/plan";

/** Of the arrow with the most to gain [px]. */
const LONGEST = 34;
const LEAST = 9;
/** From the contact to where an arrow begins [px]. */
const BEGINS = 9;

interface Arrow {
  readonly name: string;
  readonly from: Pair;
  readonly to: Pair;
  readonly text: string;
}

export class Slopes implements View {
  readonly #layer: PlanLayer;
  readonly #arrows: Pool<SVGGElement, Arrow>;

  constructor(layer: PlanLayer, context: Context) {
    this.#layer = layer;
    this.#arrows = new Pool(layer.group, makeArrow, dressArrow);
    context.hover.listen((hovered) => {
      const name = hovered?.kind === "robot" ? hovered.name : null;
      for (const node of this.#arrows.nodes) {
        put(node, { "data-hovered": name !== null && node.getAttribute("data-name") === name });
      }
    });
  }

  draw(seen: Seen): void {
    const { slopes } = seen.parts;
    const shown = slopes !== undefined && !seen.moving && seen.mode !== "push" && seen.mode !== "outline";
    const arrows = shown ? arrowsOf(slopes, seen.doc.problem.swarm.robots, this.#layer) : [];
    this.#arrows.draw(arrows.filter(({ name }) => seen.mode === "edit" || name === seen.chosen));
  }
}

/** An arrow for every robot that gains by a move; its length tells how much. */
export function arrowsOf(
  slopes: SlopesPart, robots: readonly RobotData[], layer: Pick<PlanLayer, "toScreen">,
): Arrow[] {
  const most = Math.max(0, ...slopes.rows.map((row) => row.per_metre ?? 0));
  if (most <= 0) return [];
  return slopes.rows.flatMap(({ name, per_metre, direction, text }) => {
    const robot = robots.find((one) => one.name === name);
    if (robot === undefined || direction === null || per_metre === null || per_metre <= 0) return [];
    const [x, y] = layer.toScreen(robot.contact);
    const [u, v] = layer.toScreen([robot.contact[0] + Math.cos(direction), robot.contact[1] + Math.sin(direction)]);
    const size = Math.hypot(u - x, v - y);
    const [dx, dy] = [(u - x) / size, (v - y) / size];
    const length = Math.max(LEAST, (LONGEST * per_metre) / most);
    const at = (along: number): Pair => [x + dx * along, y + dy * along];
    return [{ name, from: at(BEGINS), to: at(BEGINS + length), text }];
  });
}

function makeArrow(): SVGGElement {
  return svg("g", { class: "slope" }, svg("title"), svg("line"), svg("path"));
}

function dressArrow(node: SVGGElement, { name, from, to, text }: Arrow): void {
  const [title, line, head] = node.children;
  const way = Math.atan2(to[1] - from[1], to[0] - from[0]);
  const tip = (turn: number): string =>
    `${(to[0] - 7 * Math.cos(way + turn)).toFixed(1)} ${(to[1] - 7 * Math.sin(way + turn)).toFixed(1)}`;
  put(node, { "data-name": name });
  write(title!, `${name}: ${text}`);
  put(line!, { x1: from[0].toFixed(1), y1: from[1].toFixed(1), x2: to[0].toFixed(1), y2: to[1].toFixed(1) });
  put(head!, { d: `M${tip(0.45)}L${to[0].toFixed(1)} ${to[1].toFixed(1)}L${tip(-0.45)}` });
}
