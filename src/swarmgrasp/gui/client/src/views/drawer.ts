/* On a phone the rail is drawn up from below, with the views under tabs; on less width two share a place. */

import type { Context } from "../context";
import { el, put } from "../dom";
import type { Layout } from "../layout";

const VIEWS = [["wrench", "Wrench set"], ["rose", "Wind held"], ["land", "Places"]] as const;
type Name = (typeof VIEWS)[number][0];

export function makeDrawer(layout: Layout, context: Context): void {
  const { drawer, tiles, side } = layout;
  const tabs = el("div", { class: "tabs", role: "tablist", "aria-label": "Views" });
  const buttons = new Map<Name, HTMLButtonElement>();
  const show = (name: Name): void => {
    put(tiles, { "data-tile": name });
    for (const [other, button] of buttons) {
      put(button, { "aria-selected": String(other === name), tabindex: other === name ? 0 : -1 });
    }
  };
  for (const [name, word] of VIEWS) {
    const button = el("button", { type: "button", class: "tab", role: "tab" }, word);
    button.addEventListener("click", () => show(name));
    buttons.set(name, button);
    tabs.append(button);
  }
  tabs.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key] ?? 0;
    if (step === 0) return;
    event.preventDefault();
    const at = VIEWS.findIndex(([name]) => name === tiles.getAttribute("data-tile"));
    const [next] = VIEWS[(at + step + VIEWS.length) % VIEWS.length]!;
    show(next);
    buttons.get(next)!.focus();
  });
  swap(layout.wrench.card, "places", () => show("land"), layout.land.card);
  swap(layout.land.card, "wrench set", () => show("wrench"), layout.wrench.card);
  drawer.prepend(makeGrip(drawer, context));
  side.after(tabs);
  show("wrench");
}

/** The word in a title that shows the other view in its place. */
function swap(card: HTMLElement, word: string, show: () => void, other: HTMLElement): void {
  const button = el("button", { type: "button", class: "swap" }, word);
  button.addEventListener("click", () => {
    show();
    other.querySelector<HTMLElement>(".swap")?.focus();
  });
  card.querySelector(".tile-title")!.after(button);
}

/** How far a drag must go to count as one [px]. */
const FAR = 24;

function makeGrip(drawer: HTMLElement, context: Context): HTMLElement {
  const grip = el("button", { type: "button", class: "grip", "aria-label": "Answer and views", "aria-expanded": "false" });
  const set = (up: boolean): void => {
    put(drawer, { "data-up": up });
    put(grip, { "aria-expanded": String(up) });
    if (!up) drawer.scrollTop = 0;
  };
  let from: { y: number; height: number } | null = null;
  let dragged = false;
  grip.addEventListener("pointerdown", (event) => {
    from = { y: event.clientY, height: drawer.offsetHeight };
    dragged = false;
    grip.setPointerCapture(event.pointerId);
  });
  grip.addEventListener("pointermove", (event) => {
    if (from === null) return;
    const by = from.y - event.clientY;
    dragged ||= Math.abs(by) > 4;
    const most = context.root.clientHeight - 112;
    drawer.style.height = `${Math.max(120, Math.min(most, from.height + by))}px`;
    put(drawer, { "data-drawn": true });
  });
  grip.addEventListener("lostpointercapture", (event) => {
    const by = from === null ? 0 : from.y - event.clientY;
    from = null;
    drawer.style.height = "";
    put(drawer, { "data-drawn": false });
    if (Math.abs(by) > FAR) set(by > 0);
  });
  grip.addEventListener("click", () => {
    if (!dragged) set(!drawer.hasAttribute("data-up"));
    dragged = false;
  });
  return grip;
}
