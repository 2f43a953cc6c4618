/* In the middle of the hull: what is weakest, what loads it. */

import { put, svg, write } from "../dom";
import type { Pair, Triple } from "../messages";
import { arcPath, arrow } from "./figures";
import type { Stage } from "./stage";
import { path } from "./screen";

const SHORT = 18;
const LONG = 40;
const TURN_RADIUS = 22;
const MENTIONED = 0.25;

export class MiddleLayer {
  readonly group = svg("g", { class: "layer-middle" });
  readonly #cross = svg("path", { class: "origin" });
  readonly #weakest = new WrenchMark("weakest");
  readonly #load = new WrenchMark("load");

  constructor() {
    this.group.append(this.#load.group, this.#weakest.group, this.#cross);
  }

  draw(stage: Stage): void {
    const { seen, centre: [x, y] } = stage;
    put(this.#cross, { d: path([[x - 5, y], [x + 5, y]]) + path([[x, y - 5], [x, y + 5]]) });
    const answer = seen.parts.answer;
    const free = seen.mode !== "push";
    const load = answer?.load ?? null;
    const pushed = load !== null && Math.hypot(load[0], load[1], load[2] / seen.doc.problem.swarm.characteristic_length) > 0;
    this.#weakest.draw(stage, free ? answer?.weakest?.wrench ?? null : null);
    this.#load.draw(stage, free && pushed && answer?.weakest == null ? load : null);
  }
}

/** A wrench as an arrow for its force and an arc for its turn. */
class WrenchMark {
  readonly group: SVGGElement;
  readonly #shaft = svg("path", { class: "shaft" });
  readonly #head = svg("path", { class: "head" });
  readonly #arc = svg("path", { class: "arc" });
  readonly #arcHead = svg("path", { class: "head" });
  readonly #word = svg("text", { class: "word" });

  constructor(readonly name: string) {
    this.group = svg("g", { class: `wrench wrench-${name}` },
      this.#arc, this.#arcHead, this.#shaft, this.#head, this.#word);
    write(this.#word, name);
  }

  draw({ seen, centre, screen }: Stage, wrench: Triple | null): void {
    put(this.group, { hidden: wrench === null });
    if (wrench === null) return;
    const { characteristic_length: arm, force_weights } = seen.doc.problem.swarm;
    const [u, v, turn] = [wrench[0] * force_weights[0], wrench[1] * force_weights[1], wrench[2] / arm];
    const size = Math.hypot(u, v, turn) || 1;
    const force = Math.hypot(u, v) / size;
    const direction = Math.atan2(wrench[1], wrench[0]);
    const end = screen.step(centre, direction, SHORT + LONG * force);
    const drawn = arrow(centre, end, 1.8);
    put(this.#shaft, { d: force > MENTIONED ? drawn.shaft : "" });
    put(this.#head, { d: force > MENTIONED ? drawn.head : "" });
    const share = turn / size;
    const away = screen.angle(direction) + Math.PI;
    const half = (Math.PI * 0.9 * Math.abs(share)) / 2 + 0.5;
    const [from, to] = share > 0 ? [away - half, away + half] : [away + half, away - half];
    const turns = Math.abs(share) > MENTIONED;
    put(this.#arc, { d: turns ? arcPath(centre, TURN_RADIUS, from, to) : "" });
    put(this.#arcHead, { d: turns ? this.#tip(centre, to, Math.sign(share)) : "" });
    this.#placeWord(centre, screen.angle(direction), screen.turned);
  }

  #tip(centre: Pair, angle: number, sign: number): string {
    const at: Pair = [centre[0] + TURN_RADIUS * Math.cos(angle), centre[1] - TURN_RADIUS * Math.sin(angle)];
    const way = angle + (sign * Math.PI) / 2;
    const tip: Pair = [at[0] + 6 * Math.cos(way), at[1] - 6 * Math.sin(way)];
    return arrow([at[0] - 2 * Math.cos(way), at[1] + 2 * Math.sin(way)], tip, 1.8).head;
  }

  /** Beside the arc, on the side that the arrow leaves free; above or below it where the hull is upright. */
  #placeWord([x, y]: Pair, angle: number, upright: boolean): void {
    if (upright) {
      const below = Math.sin(angle) > 0;
      put(this.#word, { x, y: below ? y + 38 : y - 30, "text-anchor": "middle" });
      return;
    }
    const toRight = Math.cos(angle) < 0.3;
    const up = Math.sin(angle) > 0 ? -1 : 1;
    put(this.#word, {
      x: x + (toRight ? 31 : -31), y: y - up * 12 + 4, "text-anchor": toRight ? "start" : "end",
    });
  }
}
