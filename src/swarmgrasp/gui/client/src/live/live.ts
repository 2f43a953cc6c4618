/* Watches robots that decide for themselves: read-only, but for the buttons of a demonstration. */

import type { Context, Seen, View } from "../context";
import { el, Pool, put, show, write } from "../dom";
import type { Layout } from "../layout";
import type { Pair, RobotData } from "../messages";
import type { PlanLayer } from "../plan/plan";
import { countWords, cutWords, orderWord, ordersFor, sideOf, taken, wordsOf, type Agent, type LiveData, type Order } from "./agents";
import { Marks } from "./marks";

/** Where there is no demonstration, the network does not tell who hears whom. */
const HEARD = "You see what this page hears. Who of them hears whom is not told on the network.";

export class Live implements View {
  readonly #context: Context;
  readonly #marks: Marks;
  readonly #nodes;
  readonly #rows: Pool<HTMLElement, Agent>;
  readonly #orders = new WeakMap<Element, Pool<HTMLElement, Ordered>>();
  readonly #cards: readonly HTMLElement[];
  readonly #again = el("button", { type: "button", class: "control again", hidden: true }, "Watch again");
  #agents: ReadonlyMap<string, Agent> = new Map();
  #data: LiveData | null = null;
  /** Who holds: the pictures are of them. */
  #holding: string | null = null;
  #watching = false;

  constructor(layout: Layout, context: Context, layer: PlanLayer) {
    this.#context = context;
    this.#marks = new Marks(layer);
    const nodes = {
      first: el("h1", { class: "first" }), second: el("p", { class: "second" }),
      certified: el("span", { class: "after" }), unit: el("span", { class: "unit" }),
      wind: el("span", { class: "after" }), windUnit: el("span", { class: "unit" }), windWords: el("p", { class: "what-it-is" }),
      figures: el("div", { class: "figures" }), cut: el("p", { class: "cut", role: "status" }), conflicts: el("ul", { class: "refusal" }), count: el("div", { class: "tile-aside" }),
      list: el("ul", { class: "agent-list" }), network: el("button", { type: "button", class: "control network" }),
      heard: el("p", { class: "why" }, HEARD),
    };
    this.#nodes = nodes;
    const copy = el("button", { type: "button", class: "control" }, "Edit a copy");
    copy.addEventListener("click", () => this.#leave());
    nodes.figures.append(
      el("div", {}, el("p", { class: "figure" }, nodes.certified, nodes.unit), el("p", { class: "what-it-is" }, "certified now, whatever the others do")),
      el("div", {}, el("p", { class: "figure" }, nodes.wind, nodes.windUnit), nodes.windWords));
    const told = el("section", { class: "card answer of-time", "aria-label": "The swarm now" },
      nodes.conflicts, nodes.first, nodes.second, nodes.figures, el("p", { class: "copy" }, copy));
    const head = el("div", { class: "tile-head" }, el("h2", { class: "tile-title" }, "Robots"), nodes.count);
    const table = el("section", { class: "card tile tile-losses of-time", "aria-label": "Robots" },
      head, el("div", { class: "tile-body" }, nodes.network, nodes.cut, nodes.list, nodes.heard));
    nodes.network.addEventListener("click", () => this.#control(this.#data?.cut === true ? "join" : "split", null));
    this.#cards = [told, table];
    this.#rows = new Pool(nodes.list, () => this.#makeRow(), (node, agent) => this.#dressRow(node, agent));
    layout.plan.append(this.#again);
    this.#again.addEventListener("click", () => this.#watch());
    context.talk.connected.listen((connected) => {
      const welcome = context.talk.welcome.value;
      if (!connected || welcome?.watch !== true) return;
      if (!this.#watching) layout.side.append(...this.#cards);
      this.#watch();
    });
    context.talk.live.listen((data) => {
      if (data !== null) this.#take(data);
    });
  }

  draw(seen: Seen): void {
    if (!this.#isOpen) return;
    this.#follow();
    this.#marks.draw(this.#agents.values(), this.#data?.sides ?? []);
    this.#tell(seen);
  }

  get #isOpen(): boolean {
    return this.#context.root.getAttribute("data-time") === "live";
  }

  #watch(): void {
    this.#watching = true;
    this.#holding = null;
    put(this.#context.root, { "data-time": "live" });
    show(this.#again, false);
    this.#context.talk.tell({ kind: "watch", on: true });
  }

  #leave(): void {
    put(this.#context.root, { "data-time": null });
    show(this.#again, true);
    this.#marks.clear();
    this.#context.talk.tell({ kind: "watch", on: false });
    this.#again.focus();
  }

  #take(data: LiveData): void {
    this.#agents = taken(this.#agents, data);
    const before = this.#data;
    this.#data = data;
    if (!this.#isOpen) return;
    if (before === null || before.first.text !== data.first.text || before.sides.length !== data.sides.length) {
      this.#context.say(`${data.first.text}, ${data.second}. ${cutWords(data.sides)}`);
    }
    const seen = this.#context.store.seen.value;
    if (seen !== null) this.draw(seen);
  }

  /** The plan and the pictures are of those that hold: another scene when these change. */
  #follow(): void {
    const { store } = this.#context;
    const { draft } = store;
    if (draft === null || this.#data === null) return;
    const holding = [...this.#agents.values()].filter((agent) => agent.there && agent.at !== null);
    const key = JSON.stringify(holding.map(({ name, at, direction, limit }) => [name, at, direction, limit]));
    if (key === this.#holding) return;
    this.#holding = key;
    const { problem } = draft.doc;
    const robots = holding.map((agent) => robotOf(agent, problem.swarm.robots));
    const newcomer = false;
    const doc = { ...draft.doc, newcomer, problem: { ...problem, swarm: { ...problem.swarm, robots } } };
    store.open({ ...draft.scene, doc });
  }

  #tell({ parts }: Seen): void {
    const data = this.#data;
    const nodes = this.#nodes;
    show(nodes.cut, (data?.sides.length ?? 0) > 1);
    show(nodes.conflicts, (data?.conflicts.length ?? 0) > 0);
    show(nodes.figures, data !== null);
    show(nodes.network, data?.cut != null);
    show(nodes.heard, data !== null && data.cut === null);
    write(nodes.network, data?.cut === true ? "Join the network again" : "Cut the network in two");
    if (data === null) {
      write(nodes.first, "Listening");
      write(nodes.second, `no ${this.#context.speech.value.robot} has been heard yet`);
      return;
    }
    const speech = this.#context.speech.value;
    write(nodes.first, data.first.text);
    put(nodes.first, { class: data.first.good ? "first good" : "first bad" });
    write(nodes.second, data.second);
    const [certified, unit] = data.certified === null ? ["–", ""] : speech.force(data.certified).split(/\u00a0(?=[^\d]+$)/);
    write(nodes.certified, certified!);
    write(nodes.unit, unit ?? "");
    const figure = parts.capability?.figure;
    const [wind, windUnit] = parts.capability === undefined ? ["", ""] : speech.speed(parts.capability.least.speed).split(/\u00a0(?=[^\d]+$)/);
    write(nodes.wind, wind!);
    write(nodes.windUnit, windUnit ?? "");
    write(nodes.windWords, figure?.text ?? "");
    write(nodes.cut, cutWords(data.sides));
    nodes.conflicts.replaceChildren(...data.conflicts.map((words) => el("li", {}, words)));
    write(nodes.count, countWords(this.#agents.values()));
    this.#rows.draw([...this.#agents.values()]);
  }

  #makeRow(): HTMLElement {
    const name = el("span", { class: "bar-name" });
    const row = el("li", { class: "agent-row" }, name, el("span", { class: "phase" }), el("span", { class: "agent-words" }), el("span", { class: "agent-buttons" }));
    row.addEventListener("pointerenter", () => this.#context.hover.set({ kind: "robot", name: name.textContent ?? "" }));
    row.addEventListener("pointerleave", () => this.#context.hover.set(null));
    row.addEventListener("click", (event) => {
      const order = (event.target as Element).closest("button")?.getAttribute("data-order");
      if (order != null) this.#control(order as Order, name.textContent);
    });
    this.#orders.set(row, new Pool(row.lastElementChild!, makeOrder, dressOrder));
    return row;
  }

  #dressRow(row: HTMLElement, agent: Agent): void {
    const [name, phase, words] = row.children;
    write(name!, agent.name);
    write(phase!, agent.phase);
    const side = sideOf(agent.name, this.#data?.sides ?? []);
    put(row, { "data-phase": agent.phase, "data-side": side === null ? null : side % 3 });
    write(words!, wordsOf(agent));
    put(words!, { title: wordsOf(agent) });
    this.#orders.get(row)!.draw(ordersFor(agent).map((order) => ({ order, word: orderWord(order, agent), name: agent.name })));
  }

  #control(what: Order | "split" | "join", robot: string | null): void {
    this.#context.talk.tell({ kind: "control", what, robot });
  }
}

interface Ordered {
  readonly order: Order;
  readonly word: string;
  readonly name: string;
}

function makeOrder(): HTMLElement {
  return el("button", { type: "button", class: "control small" });
}

function dressOrder(button: HTMLElement, { order, word, name }: Ordered): void {
  write(button, word);
  put(button, { "data-order": order, "aria-label": `${word} ${name}` });
}

/** A live robot in the plain form, with what the scenario says of one of its name. */
function robotOf({ name, at, direction: way, limit }: Agent, known: readonly RobotData[]): RobotData {
  const own = known.find((robot) => robot.name === name);
  const contact: Pair = at ?? [0, 0];
  const direction = way ?? 0;
  const plain: RobotData = {
    contact, direction, limit, name, mounted: false, tolerance: null, reverse_limit: 0, steers: 0,
    friction: null, least: 0, envelope: null, group: "", sectors: null, body: null, lever: 0,
  };
  return own === undefined ? plain : { ...own, contact, direction, limit };
}
