/* The hull, where a newcomer may come, and how good each place is. */

import { Pool, put, svg, write } from "../dom";
import type { LandscapePart, Pair, StretchData, ZoneData } from "../messages";
import { figure } from "../speech";
import type { Stage } from "./stage";
import { path } from "./screen";
import { distance } from "./shape";

const OFF_HULL = 9;
const ROUND = [1, 2, 5];
/** Pixels between the word and a contact. */
const NEAR_WORD = 20;

interface Cell {
  readonly d: string;
  /** How good, in percent of the way from the least to the most. */
  readonly share: number;
}

export class HullLayer {
  readonly group = svg("g", { class: "layer-hull" });
  readonly #hull = svg("path", { class: "hull" });
  readonly #bow = svg("text", { class: "bow", "text-anchor": "middle", "dominant-baseline": "middle" });
  readonly #areas: Pool<SVGPathElement, ZoneData>;
  readonly #strips: Pool<SVGPathElement, { d: string; name: string }>;
  readonly #cells: Pool<SVGPathElement, Cell>;
  readonly #bollards: Pool<SVGCircleElement, { at: Pair; share: number; name: string }>;
  readonly #forbidden: Pool<SVGPathElement, string>;
  #stage: Stage | null = null;

  constructor() {
    const [areas, strips, cells, forbidden, bollards] = ["areas", "strips", "cells", "no-go", "bollards"]
      .map((name) => svg("g", { class: name })) as [SVGGElement, SVGGElement, SVGGElement, SVGGElement, SVGGElement];
    this.group.append(this.#hull, areas, this.#bow, strips, cells, forbidden, bollards);
    this.#areas = new Pool(areas, () => svg("path", { class: "area" }), (node, zone) => {
      const screen = this.#stage!.screen;
      const corners = zone.area!.map((corner) => screen.at(corner));
      put(node, { d: path(corners, true), "data-zone": zone.name, class: this.#class("area", zone.name) });
    });
    this.#strips = new Pool(strips, () => svg("path", {}), (node, { d, name }) =>
      put(node, { d, "data-zone": name, class: this.#class("strip", name) }));
    this.#cells = new Pool(cells, () => svg("path"), (node, { d, share }) =>
      put(node, { d, class: `cell share-${Math.round(share * 20)}` }));
    this.#forbidden = new Pool(forbidden, () => svg("path", { class: "forbidden" }), (node, d) => put(node, { d }));
    this.#bollards = new Pool(bollards, () => svg("circle", { r: 4 }), (node, { at, share, name }) =>
      put(node, {
        cx: at[0], cy: at[1], "data-zone": name,
        class: `${this.#class("bollard", name)} share-${Math.round(share * share * 20)}`,
      }));
  }

  draw(stage: Stage): void {
    this.#stage = stage;
    const { shape, screen, seen } = stage;
    const { zones, no_go } = seen.doc.problem;
    put(this.#hull, { d: path(shape.vertices.map((corner) => screen.at(corner)), true) });
    this.#drawBow(stage);
    const all = seen.doc.newcomer ? zones ?? [] : [];
    this.#areas.draw(all.filter((zone) => zone.area !== null));
    const stretches = all.filter((zone) => zone.stretch !== null && zone.stretch.start !== zone.stretch.end);
    this.#strips.draw(stretches.map((zone) => ({ d: this.#strip(zone.stretch!), name: zone.name })));
    const land = seen.parts.landscape;
    const [strip, spots] = land === undefined || !seen.doc.newcomer ? [[], new Map<number, number>()] : this.#values(land);
    this.#cells.draw(strip);
    this.#bollards.draw(all.filter((zone) => zone.stretch !== null && zone.stretch.start === zone.stretch.end)
      .map((zone) => ({
        at: screen.at(shape.placeAt(zone.stretch!.start).at),
        share: spots.get(Math.round(zone.stretch!.start * 1e4)) ?? 0, name: zone.name,
      })));
    this.#forbidden.draw(no_go.map((stretch) => this.#strip(stretch)));
  }

  #class(name: string, zone: string): string {
    const hovered = this.#stage!.hovered;
    return hovered?.kind === "zone" && hovered.name === zone ? `${name} hovered` : name;
  }

  #drawBow({ shape, screen, figures, newcomer }: Stage): void {
    const { right } = shape.box;
    const heights = shape.vertices.filter(([x]) => x > right - 0.02 * shape.perimeter).map(([, y]) => y);
    const middle = heights.reduce((sum, y) => sum + y, 0) / heights.length;
    const [x, y] = screen.at([right, middle]);
    const spots = [20, 50, 80, 110].map((back): Pair => (screen.turned ? [x, y + back] : [x - back - 24, y]));
    const taken = [...figures, ...(newcomer === null ? [] : [newcomer])].map(({ contact }) => contact);
    const free = spots.find((spot) => taken.every((contact) => distance(contact, spot) > NEAR_WORD)) ?? spots[0]!;
    put(this.#bow, { x: free[0], y: free[1] });
    write(this.#bow, "bow");
  }

  /** The line beside a stretch of the boundary, outside the hull. */
  #strip(stretch: StretchData): string {
    if (stretch.start === stretch.end) return this.#between(stretch.start, stretch.start);
    return this.#between(stretch.start, stretch.end);
  }

  #between(start: number, end: number): string {
    const { shape, screen } = this.#stage!;
    return shape.pieces(start, end).map(({ edge, from, to }) => {
      const outward = shape.inward(edge) + Math.PI;
      return path([from, to].map((point) => screen.step(screen.at(point), outward, OFF_HULL)));
    }).join("");
  }

  /** The best over all directions at each place, as cells of the strip and as spots. */
  #values(land: LandscapePart): [Cell[], Map<number, number>] {
    const cells: Cell[] = [];
    const spots = new Map<number, number>();
    const span = Math.max(land.high - land.low, 1e-300);
    const seam = 1 / this.#stage!.screen.scale;
    let first = 0;
    for (const piece of land.pieces) {
      const { columns } = piece;
      columns.forEach((along, i) => {
        const value = land.strip[first + i]!;
        if (value === 0) return;
        const share = Math.max(0, Math.min(1, ((value - 1) * land.unit - land.low) / span));
        if (piece.end <= piece.start) {
          spots.set(Math.round(along * 1e4), share);
          return;
        }
        const from = i === 0 ? piece.start : (columns[i - 1]! + along) / 2;
        // Each reaches a little under the next, so that no seam shows.
        const to = i === columns.length - 1 ? piece.end : Math.min(piece.end, (along + columns[i + 1]!) / 2 + seam);
        if (share > 0.02) cells.push({ d: this.#between(from, to), share });
      });
      first += columns.length;
    }
    return [cells, spots];
  }
}

/** The bars of one length and of one force, at the lower left or, on phones, the upper right. */
export class ScaleLayer {
  readonly group = svg("g", { class: "layer-scale" });
  readonly #length = svg("path", { class: "bar-length" });
  readonly #lengthText = svg("text", { class: "scale-text" });
  readonly #force = svg("path", { class: "bar-force" });
  readonly #forceText = svg("text", { class: "scale-text" });

  constructor() {
    this.group.append(this.#length, this.#lengthText, this.#force, this.#forceText);
  }

  draw({ screen, speech, scale }: Stage, hidden: boolean): void {
    put(this.group, { hidden });
    const { size, label } = speech.data.length;
    const long = round(88 / screen.scale / size, 1);
    const pixels = long * size * screen.scale;
    const unit = speech.forceUnit(scale.largest);
    const strong = round(scale.largest / unit.size, 0.9);
    const strength = (strong * unit.size / scale.largest) * scale.longest;
    if (screen.width < 520) {
      const right = screen.width - 18;
      put(this.#length, { d: path([[right - pixels, 22], [right - pixels, 26], [right, 26], [right, 22]]) });
      put(this.#lengthText, { x: right, y: 16, "text-anchor": "end" });
      put(this.#force, { d: "" });
      write(this.#forceText, "");
    } else {
      const y = screen.height - 23;
      put(this.#length, { d: path([[24, y - 4], [24, y], [24 + pixels, y], [24 + pixels, y - 4]]) });
      put(this.#lengthText, { x: 32 + pixels, y: y + 2, "text-anchor": "start" });
      const x = 32 + pixels + 58;
      put(this.#force, { d: path([[x, y - 2], [x + strength, y - 2]]) });
      put(this.#forceText, { x: x + strength + 8, y: y + 2 });
      write(this.#forceText, `${figure(strong)}\u00a0${unit.label}`);
    }
    write(this.#lengthText, `${figure(long)}\u00a0${label}`);
  }
}

/** The largest round number that is at most `share` of another. */
function round(value: number, share: number): number {
  const most = value * share;
  const power = 10 ** Math.floor(Math.log10(most));
  const best = ROUND.filter((step) => step * power <= most * (1 + 1e-9)).at(-1) ?? 1;
  return best * power;
}
