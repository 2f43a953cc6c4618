/* Where everything stands: a bar, the plan with three tiles under it, a rail, and what lies over them. */

import { el } from "./dom";

export interface Tile {
  readonly card: HTMLElement;
  /** Right of the title: a legend, a figure. */
  readonly aside: HTMLElement;
  /** What a view draws in. */
  readonly body: HTMLElement;
}

export interface Layout {
  readonly bar: HTMLElement;
  readonly plan: HTMLElement;
  readonly timeline: HTMLElement;
  /** Of the rail and the tiles, which a phone draws up from below. */
  readonly drawer: HTMLElement;
  readonly tiles: HTMLElement;
  readonly side: HTMLElement;
  /** The answer in words. */
  readonly answer: HTMLElement;
  readonly losses: Tile;
  readonly text: HTMLElement;
  readonly wrench: Tile;
  readonly rose: Tile;
  readonly land: Tile;
  readonly banner: HTMLElement;
  readonly toasts: HTMLElement;
  readonly spoken: HTMLElement;
  /** For what lies over the page: menu, keys. */
  readonly over: HTMLElement;
}

function tile(name: string, title: string): Tile {
  const aside = el("div", { class: "tile-aside" });
  const body = el("div", { class: "tile-body" });
  const head = el("div", { class: "tile-head" }, el("h2", { class: "tile-title" }, title), aside);
  const card = el("section", { class: `card tile tile-${name}`, "aria-label": title }, head, body);
  return { card, aside, body };
}

/** Builds the frame of the page in an element. */
export function layout(root: HTMLElement): Layout {
  const bar = el("header", { class: "bar" });
  const timeline = el("div", { class: "timeline", hidden: true });
  const plan = el("section", { class: "card plan", "aria-label": "Plan" });
  const answer = el("section", { class: "card answer", "aria-label": "Answer" });
  const losses = tile("losses", "What each loss leaves");
  const text = el("section", { class: "card text", "aria-label": "Scenario as text", hidden: true });
  const wrench = tile("wrench", "Wrench set");
  const rose = tile("rose", "Wind held");
  const land = tile("land", "Places and directions");
  const side = el("div", { class: "side" }, answer, losses.card, text);
  const tiles = el("div", { class: "tiles" }, wrench.card, rose.card, land.card);
  const drawer = el("div", { class: "drawer" }, side, tiles);
  const banner = el("div", { class: "banner", role: "status", hidden: true });
  const toasts = el("div", { class: "toasts", role: "status" });
  const spoken = el("div", { class: "spoken", role: "status", "aria-live": "polite" });
  const over = el("div", { class: "over" });
  const main = el("main", { class: "main" }, plan, drawer);
  root.classList.add("studio");
  root.replaceChildren(bar, banner, main, toasts, spoken, over);
  plan.append(timeline);
  return {
    bar, plan, timeline, drawer, tiles, side, answer, losses, text, wrench, rose, land, banner, toasts, spoken, over,
  };
}
