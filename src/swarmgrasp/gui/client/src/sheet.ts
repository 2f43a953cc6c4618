/* What lies over the page for a while: a menu, the keys. Escape and a click beside it close it. */

import { el, put } from "./dom";

export class Sheet {
  readonly #room: HTMLElement;
  #open: { card: HTMLElement; back: Element | null; opener: HTMLElement | null } | null = null;

  constructor(room: HTMLElement) {
    this.#room = room;
    room.addEventListener("pointerdown", (event) => {
      if (event.target === room) this.close();
    });
    room.addEventListener("keydown", (event) => this.#key(event));
    put(room, { hidden: true });
  }

  get isOpen(): boolean {
    return this.#open !== null;
  }

  open(card: HTMLElement, opener: HTMLElement | null = null): void {
    this.close();
    const root = card.getRootNode() as Document | ShadowRoot;
    const back = (this.#room.getRootNode() as Document | ShadowRoot).activeElement ?? root.activeElement ?? null;
    this.#open = { card, back, opener };
    if (opener !== null) put(opener, { "aria-expanded": "true" });
    put(this.#room, { hidden: false });
    this.#room.replaceChildren(card);
    card.querySelector<HTMLElement>("button, [tabindex]")?.focus();
  }

  close(): void {
    if (this.#open === null) return;
    const { back, opener } = this.#open;
    this.#open = null;
    if (opener !== null) put(opener, { "aria-expanded": "false" });
    this.#room.replaceChildren();
    put(this.#room, { hidden: true });
    if (back instanceof HTMLElement || back instanceof SVGElement) back.focus();
  }

  #key(event: KeyboardEvent): void {
    event.stopPropagation();
    if (event.key === "Escape") {
      this.close();
      event.preventDefault();
      return;
    }
    const items = [...this.#room.querySelectorAll<HTMLElement>("button, [tabindex]")];
    const now = items.findIndex((item) => item.matches(":focus"));
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by !== undefined) {
      items[(now + by + items.length) % items.length]?.focus();
      event.preventDefault();
    } else if (event.key === "Tab") {
      const last = event.shiftKey ? 0 : items.length - 1;
      if (now === last) {
        items[event.shiftKey ? items.length - 1 : 0]?.focus();
        event.preventDefault();
      }
    }
  }
}

const KEYS: readonly (readonly [string, string])[] = [
  ["Tab", "into the plan, and out of it"],
  [",  .", "the robot before, the next one"],
  ["arrows", "move it along its side; with Shift by ten"],
  ["[  ]", "turn it by a degree; with Shift by ten"],
  ["+  −", "more limit, less limit"],
  ["F", "push or pull"],
  ["A", "add one"],
  ["D", "another one beside it"],
  ["Delete", "take it away"],
  ["N", "the newcomer; Enter keeps it"],
  ["M", "more of who is chosen: tolerance, body, group, gaps"],
  ["Z", "zones; again: the outline"],
  ["H", "push forces for a wrench"],
  ["0 – 3", "how many are lost"],
  ["W", "wind, or none"],
  ["T", "the scenario as text"],
  ["Ctrl Z", "undo; with Shift redo"],
  ["Ctrl S", "save as YAML"],
  ["Ctrl O", "open a file"],
  ["Space", "play or pause a run; < > its speed"],
  ["?", "these keys"],
  ["Esc", "lets go"],
];

/** The sheet of keys. */
export function keysCard(close: () => void): HTMLElement {
  const rows = KEYS.flatMap(([key, what]) => [el("dt", {}, el("kbd", {}, key)), el("dd", {}, what)]);
  const done = el("button", { type: "button", class: "control" }, "Close");
  done.addEventListener("click", close);
  return el("div", { class: "card sheet-card keys-card", role: "dialog", "aria-modal": "true", "aria-label": "Keys" },
    el("h2", {}, "Keys"), el("dl", {}, ...rows),
    el("p", {}, "Drag with Shift to snap, with Alt on the round handle to change the limit. Numbers are dragged sideways or typed."), done);
}
