/* Beside the run: its verdict, where the object is now, what is missing, and what happened. */

import type { Context } from "../context";
import { el, put, show, write } from "../dom";
import type { RunHappening } from "../messages";
import { Bars, type BarRow } from "../views/bars";
import { clock, type Film, type Moment } from "./film";
import { saidOf } from "./sea";

export class Rail {
  readonly cards: readonly HTMLElement[];
  readonly #off = el("span", { class: "after" });
  readonly #offUnit = el("span", { class: "unit" });
  readonly #turned = el("span", { class: "after" });
  readonly #missing = el("p", { class: "missing" });
  readonly #events: HTMLElement[];
  readonly #bars: Bars;
  readonly #film: Film;
  readonly #context: Context;

  constructor(film: Film, context: Context, seek: (time: number) => void) {
    this.#film = film;
    this.#context = context;
    const { first, second, happenings } = film.data;
    const figures = el("div", { class: "figures" },
      el("div", {}, el("p", { class: "figure" }, this.#off, this.#offUnit), el("p", { class: "what-it-is" }, "off its place now")),
      el("div", {}, el("p", { class: "figure" }, this.#turned, el("span", { class: "unit" }, "°")), el("p", { class: "what-it-is" }, "turned now")));
    const list = el("ul", { class: "events" });
    this.#events = happenings.map((event) => {
      const button = makeEvent(event);
      button.addEventListener("click", () => seek(event.time));
      list.append(el("li", {}, button));
      return button;
    });
    const told = el("section", { class: "card answer", "aria-label": "The run" },
      el("h1", { class: first.good ? "first good" : "first bad" }, first.text), el("p", { class: "second" }, second),
      figures, this.#missing, el("div", { class: "happened" }, el("h2", { class: "tile-title" }, "What happened"), list));
    const body = el("div", { class: "tile-body" });
    const head = el("div", { class: "tile-head" }, el("h2", { class: "tile-title" }, "How hard each pushes"), el("div", { class: "tile-aside" }, "of its limit"));
    const shares = el("section", { class: "card tile tile-losses", "aria-label": "How hard each pushes" }, head, body);
    this.#bars = new Bars(body, context);
    this.cards = [told, shares];
  }

  draw(moment: Moment, chosen: string | null): void {
    const speech = this.#context.speech.value;
    const [off, unit] = speech.length(moment.off, moment.off / speech.data.length.size < 9.95 ? 1 : 0).split("\u00a0");
    write(this.#off, off!);
    write(this.#offUnit, unit!);
    put(this.#off, { "data-bad": moment.off > this.#film.data.within });
    write(this.#turned, String(Math.round((moment.turned * 180) / Math.PI)));
    put(this.#turned, { "data-bad": moment.turned > this.#film.data.turn });
    const missing = moment.shortfall > 1e-3 * this.#largest();
    show(this.#missing, missing);
    if (missing) write(this.#missing, `${speech.force(moment.shortfall)} missing to hold against the weather`);
    for (const [i, event] of this.#film.data.happenings.entries()) {
      put(this.#events[i]!, { "data-to-come": event.time > moment.time });
    }
    this.#bars.draw(moment.robots.filter(({ phase }) => phase !== "away").map((standing): BarRow => {
      const text = saidOf(standing);
      return {
        name: standing.actor.name, share: standing.share, text, bad: standing.phase === "lost",
        marked: standing.actor.newcomer, own: standing.actor.newcomer, sentence: `${standing.actor.name}: ${text}`,
      };
    }), chosen);
  }

  #largest(): number {
    return Math.max(...this.#film.data.robots.map(({ limit }) => limit));
  }
}

function makeEvent({ time, kind, words }: RunHappening): HTMLElement {
  return el("button", { type: "button", class: "event", "data-kind": kind },
    el("span", { class: "event-time" }, clock(time)), el("span", {}, words));
}
