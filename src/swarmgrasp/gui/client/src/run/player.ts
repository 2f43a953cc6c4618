/* Plays a recorded run in the place of the plan. */

import type { Context, Seen, View } from "../context";
import { el, put, show } from "../dom";
import type { Layout } from "../layout";
import { whenLooksChange } from "../views/paint";
import { clock, Film, type Moment, type RunData } from "./film";
import { Rail } from "./rail";
import { Sea } from "./sea";
import { Timeline } from "./timeline";

interface Shown {
  readonly film: Film;
  readonly sea: Sea;
  readonly rail: Rail;
  readonly timeline: Timeline;
}

export class Player implements View {
  readonly #canvas = el("canvas", { class: "sea", role: "img" });
  readonly #again = el("button", { type: "button", class: "control again", hidden: true }, "Play the run");
  #shown: Shown | null = null;
  #time = 0;
  #asked = "";
  /** Who holds: the pictures are of them. */
  #holding = "";

  constructor(readonly layout: Layout, readonly context: Context) {
    layout.plan.append(this.#canvas, this.#again);
    this.#again.addEventListener("click", () => this.open());
    context.talk.welcome.listen((welcome) => {
      if (welcome?.run != null && welcome.run !== this.#asked) void this.#fetch(welcome.run);
    });
    context.root.addEventListener("keydown", (event) => {
      if (!this.isOpen || event.altKey || event.ctrlKey || event.metaKey) return;
      if (!this.#shown!.timeline.key(event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    context.hover.listen(() => this.#draw());
    whenLooksChange(context.root, this.#canvas, () => this.#draw());
  }

  get isOpen(): boolean {
    return this.context.root.getAttribute("data-time") === "run";
  }

  /** Its terms or who is chosen may be others; time is its own. */
  draw(_seen: Seen): void {
    this.#draw();
  }

  open(): void {
    if (this.#shown === null) return;
    put(this.context.root, { "data-time": "run" });
    show(this.layout.timeline, true);
    show(this.#again, false);
    this.#holding = "";
    this.#draw();
  }

  close(): void {
    this.#shown?.timeline.pause();
    put(this.context.root, { "data-time": null });
    show(this.layout.timeline, false);
    show(this.#again, true);
    const { store } = this.context;
    if (store.draft !== null) store.ask(store.draft, false);
    this.#again.focus();
  }

  async #fetch(name: string): Promise<void> {
    this.#asked = name;
    const reply = await this.context.talk.request({ kind: "run", name });
    if (reply.kind === "error") this.context.toast(reply.say);
    else if (reply.kind === "run") this.#begin(reply);
  }

  #begin(data: RunData): void {
    const film = new Film(data);
    this.#time = 0;
    const rail = new Rail(film, this.context, (time) => this.#seek(time));
    for (const card of rail.cards) {
      card.classList.add("of-time");
      this.layout.side.append(card);
    }
    const timeline = new Timeline(this.layout.timeline, film, this.context, {
      time: () => this.#time, seek: (time) => this.#seek(time), close: () => this.close(),
    });
    this.#shown = { film, sea: new Sea(this.#canvas, film), rail, timeline };
    this.open();
    this.context.say(`${data.first.text}; ${data.second}`);
  }

  #seek(time: number): void {
    this.#time = time;
    this.#draw();
  }

  #draw(): void {
    if (this.#shown === null || !this.isOpen) return;
    const { film, sea, rail, timeline } = this.#shown;
    const hovered = this.context.hover.value;
    const moment = film.at(this.#time);
    sea.draw(moment, hovered?.kind === "robot" ? hovered.name : null, this.context.speech.value);
    rail.draw(moment, this.context.store.seen.value?.chosen ?? null);
    const words = this.#words(moment);
    timeline.moved(words);
    put(this.#canvas, { "aria-label": `The object and its robots at ${clock(this.#time)}: ${words}` });
    this.#askFor(moment);
  }

  #words({ off, turned }: Moment): string {
    return `${this.context.speech.value.length(off)} off, ${Math.round((turned * 180) / Math.PI)}° turned`;
  }

  /** The pictures belong to those who hold: asked about again when these change. */
  #askFor(moment: Moment): void {
    const { store } = this.context;
    const { draft } = store;
    if (draft === null) return;
    const holding = moment.robots.filter(({ phase }) => phase === "holds").map(({ actor }) => actor);
    const key = holding.map(({ name }) => name).join("\n");
    if (key === this.#holding) return;
    this.#holding = key;
    const { problem } = draft.doc;
    const model = problem.swarm.robots[0];
    if (model === undefined) return;
    const [x, y] = problem.swarm.outline.origin;
    const robots = holding.map((actor) => problem.swarm.robots.find(({ name }) => name === actor.name) ?? {
      ...model, name: actor.name, direction: actor.direction, limit: actor.limit, group: "", sectors: null,
      contact: [actor.contact[0] + x, actor.contact[1] + y] as [number, number],
    });
    const newcomer = draft.doc.newcomer && !holding.some(({ name }) => name === problem.newcomer.name);
    const doc = { ...draft.doc, newcomer, problem: { ...problem, swarm: { ...problem.swarm, robots } } };
    store.ask({ ...draft, doc }, false);
  }
}
