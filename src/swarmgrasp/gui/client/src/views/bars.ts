/* A table of names, bars and figures: losses, shares. */

import type { Context } from "../context";
import { el, Pool, put, write } from "../dom";

export interface BarRow {
  readonly name: string;
  /** Length of the bar, 0 to 1. */
  readonly share: number;
  readonly text: string;
  readonly bad: boolean;
  /** Whether the bar has the newcomer's colour. */
  readonly marked: boolean;
  /** Whether it is the newcomer's own row. */
  readonly own: boolean;
  /** The row in words. */
  readonly sentence: string;
}

export class Bars {
  readonly #pool: Pool<HTMLElement, BarRow>;
  readonly #why: HTMLElement;
  #chosen: string | null = null;

  constructor(body: HTMLElement, readonly context: Context) {
    const list = el("ul", { class: "bars" });
    this.#why = el("p", { class: "why" });
    body.replaceChildren(list, this.#why);
    this.#pool = new Pool(list, makeRow, dressRow);
    const { hover, store } = context;
    const nameOf = (event: Event): string | null =>
      (event.target as Element).closest("button")?.getAttribute("data-name") ?? null;
    list.addEventListener("click", (event) => {
      const name = nameOf(event);
      if (name !== null) store.choose(store.seen.value?.chosen === name ? null : name);
    });
    for (const kind of ["pointerover", "focusin"]) {
      list.addEventListener(kind, (event) => {
        const name = nameOf(event);
        hover.set(name === null ? null : { kind: "robot", name });
      });
    }
    for (const kind of ["pointerleave", "focusout"]) list.addEventListener(kind, () => hover.set(null));
    hover.listen(() => this.#mark());
  }

  draw(rows: readonly BarRow[], chosen: string | null, why = ""): void {
    this.#chosen = chosen;
    this.#pool.draw(rows);
    this.#mark();
    write(this.#why, why);
  }

  /** Marks the rows of who is chosen and of who is pointed at. */
  #mark(): void {
    const hovered = this.context.hover.value;
    for (const row of this.#pool.nodes) {
      const button = row.firstElementChild!;
      const name = button.getAttribute("data-name");
      put(button, {
        "aria-pressed": String(name === this.#chosen),
        "data-hovered": hovered?.kind === "robot" && hovered.name === name,
      });
    }
  }
}

function makeRow(): HTMLElement {
  const bar = el("span", { class: "bar-track", "aria-hidden": "true" }, el("span", { class: "bar-fill" }));
  const button = el("button", { type: "button", class: "bar-row" },
    el("span", { class: "bar-name" }), bar, el("span", { class: "bar-figure" }));
  return el("li", {}, button);
}

function dressRow(node: HTMLElement, row: BarRow): void {
  const button = node.firstElementChild!;
  const [name, track, text] = button.children;
  put(button, {
    "data-name": row.name, "data-bad": row.bad, "data-marked": row.marked, "data-own": row.own,
    "aria-label": row.sentence,
  });
  write(name!, row.name);
  write(text!, row.text);
  (track!.firstElementChild as HTMLElement).style.width = `${100 * Math.min(Math.max(row.share, 0), 1)}%`;
}
