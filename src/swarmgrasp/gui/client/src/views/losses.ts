/* What each loss leaves; while forces are pushed, how hard each pushes. */

import type { Context, Seen, View } from "../context";
import { write } from "../dom";
import type { Tile } from "../layout";
import type { Forces, LossesPart } from "../messages";
import { Bars, type BarRow } from "./bars";

export class Losses implements View {
  readonly #tile: Tile;
  readonly #title: Element;
  readonly #bars: Bars;
  #drawn: readonly unknown[] = [];

  constructor(tile: Tile, context: Context) {
    this.#tile = tile;
    this.#title = tile.card.querySelector(".tile-title")!;
    this.#bars = new Bars(tile.body, context);
  }

  draw(seen: Seen): void {
    const { losses, answer } = seen.parts;
    const own = answer?.newcomer?.name ?? null;
    const inputs = [losses, own, seen.forces, seen.chosen, seen.empty.losses];
    if (inputs.every((input, i) => input === this.#drawn[i])) return;
    this.#drawn = inputs;
    if (seen.forces !== null) this.#drawShares(seen.forces, own, seen.chosen);
    else this.#drawLosses(losses, own, seen);
  }

  #drawLosses(losses: LossesPart | undefined, own: string | null, seen: Seen): void {
    write(this.#title, "What each loss leaves");
    write(this.#tile.aside, losses?.text ?? "");
    const rows = losses === undefined ? [] : lossRows(losses, own);
    this.#bars.draw(rows, seen.chosen, seen.empty.losses ?? "");
  }

  #drawShares(forces: Forces, own: string | null, chosen: string | null): void {
    write(this.#title, "How hard each pushes");
    write(this.#tile.aside, "of its limit");
    this.#bars.draw(forces.robots.map((robot) => shareRow(robot, own)), chosen, "");
  }
}

/** Worst first; a bar is as long as what is left of all there. */
export function lossRows(losses: LossesPart, own: string | null): BarRow[] {
  return losses.rows.map(({ name, value, held, worst, text }) => ({
    name, text, bad: !held, marked: worst && held, own: name === own,
    share: held && losses.all > 0 ? value / losses.all : 0,
    sentence: `Without ${name}: ${text}${worst ? ", the worst" : ""}`,
  }));
}

export function shareRow(robot: Forces["robots"][number], own: string | null): BarRow {
  const text = `${Math.round(100 * robot.share)}\u00a0%`;
  return {
    name: robot.name, share: robot.share, text, bad: robot.share > 1 + 1e-9, marked: robot.name === own,
    own: robot.name === own, sentence: `${robot.name}: ${robot.say}`,
  };
}
