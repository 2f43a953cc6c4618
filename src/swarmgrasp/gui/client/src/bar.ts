/* The bar: whose scenario, what if, and the page's own buttons. The sentence's numbers are its controls. */

import type { Context, Seen, View } from "./context";
import { el, icon, iconButton, put, show, write } from "./dom";
import type { CriterionData, Doc, EnvironmentData } from "./messages";
import type { Later } from "./sequence";
import { type BlowData, figure } from "./speech";
import { Spin, Word, type SpinOptions } from "./spin";

const MOST_LOST = 3;
const MOST_LATER = 4;
const DEGREE = Math.PI / 180;
/** A wind to begin with where a file has none: 25 knots from 60 degrees. */
export const WIND = { speed: 12.861, bearing: Math.PI / 3 };

export interface BarButtons {
  readonly menu: () => void;
  readonly text: () => void;
  readonly theme: () => void;
  readonly keys: () => void;
  readonly share: () => void;
}

export class Bar implements View {
  readonly name = el("button", { type: "button", class: "scene-name", "aria-haspopup": "menu" });
  readonly #title = el("h1", { class: "scene-title" }, "Scenes");
  readonly #undo: HTMLButtonElement;
  readonly #redo: HTMLButtonElement;
  readonly textButton: HTMLButtonElement;
  readonly losing = new Spin();
  readonly #group = new Spin();
  readonly #weather = new Word();
  readonly wind = new Spin();
  readonly #from = new Spin();
  readonly #current = new Spin();
  readonly #currentFrom = new Spin();
  readonly #poses = new Word();
  readonly #comes = new Word();
  readonly #limit = new Spin();
  readonly #later = new Spin();
  readonly #together = new Word();
  readonly #words = {
    lose: el("span", { class: "first-words" }), from: el("span"), current: el("span"), currentFrom: el("span"),
    brings: el("span"), then: el("span"), more: el("span"), group: el("span"),
  };

  constructor(bar: HTMLElement, readonly context: Context, readonly later: Later, buttons: BarButtons) {
    const { store } = context;
    this.name.append(this.#title, icon("down"));
    this.name.addEventListener("click", buttons.menu);
    this.#undo = iconButton("undo", "Undo", () => store.undo());
    this.#redo = iconButton("redo", "Redo", () => store.redo());
    this.textButton = iconButton("text", "Scenario as text", buttons.text);
    const sentence = el("div", { class: "whatif", role: "group", "aria-label": "What if" },
      this.#words.lose, this.losing.node, this.#words.group, this.#group.node, this.#weather.node, this.wind.node,
      this.#words.from, this.#from.node, this.#words.current, this.#current.node, this.#words.currentFrom,
      this.#currentFrom.node, this.#poses.node, this.#comes.node, this.#words.brings, this.#limit.node,
      this.#words.then, this.#later.node, this.#words.more, this.#together.node);
    const icons = el("div", { class: "bar-icons" }, this.#undo, this.#redo, el("span", { class: "bar-rule" }),
      iconButton("share", "Copy a link to this", buttons.share), this.textButton,
      iconButton("theme", "Dark or light", buttons.theme), iconButton("help", "Keys", buttons.keys));
    bar.append(this.name, sentence, icons);
    const share = icons.querySelector(".icon-share")!.parentElement!;
    share.classList.add("share-button");
    show(share, context.root.dataset.home === "page"); // a notebook's address opens nothing of this
    icons.querySelector(".icon-help")!.parentElement!.classList.add("help-button");
  }

  draw(seen: Seen): void {
    const { store } = this.context;
    write(this.#title, seen.doc.name);
    this.#undo.disabled = !store.canUndo;
    this.#redo.disabled = !store.canRedo;
    this.#drawLosses(seen.doc);
    this.#drawWeather(seen.doc);
    this.#drawNewcomer(seen.doc);
  }

  #criterion(change: Partial<CriterionData>, moving = false): void {
    this.context.store.editProblem((problem) => ({ ...problem, criterion: { ...problem.criterion, ...change } }), moving);
  }

  #spin(options: Omit<SpinOptions, "settle">): SpinOptions {
    return { ...options, settle: () => this.context.store.settle() };
  }

  #drawLosses({ problem }: Doc): void {
    const { criterion, swarm, newcomer } = problem;
    write(this.#words.lose, "What if we lose");
    const most = Math.max(criterion.losing, Math.min(MOST_LOST, swarm.robots.length));
    this.losing.draw(criterion.losing, this.#spin({
      label: "How many are lost", min: 0, max: most, step: 1, text: (n) => (n === 0 ? "none" : String(n)),
      change: (losing, moving) => this.#criterion({ losing }, moving),
    }));
    const groups = [...new Set(swarm.robots.map(({ group }) => group).filter((group) => group !== ""))];
    show(this.#group.node, groups.length > 0 || criterion.failures.length > 0);
    show(this.#words.group, groups.length > 0 || criterion.failures.length > 0);
    write(this.#words.group, "and");
    const choices: [string, string[][]][] = [["no group", []], ...groups.map((group): [string, string[][]] => [group, [[group]]])];
    if (groups.length > 1) choices.push(["any one group", groups.map((group) => [group])]);
    const now = JSON.stringify(criterion.failures);
    if (!choices.some(([, failures]) => JSON.stringify(failures) === now)) choices.push(["those named in the file", criterion.failures]);
    this.#group.draw(choices.findIndex(([, failures]) => JSON.stringify(failures) === now), this.#spin({
      label: "Which group is lost", min: 0, max: choices.length - 1, step: 1, text: (i) => choices[i]?.[0] ?? "",
      change: (i, moving) => this.#criterion({ failures: choices[i]![1] }, moving),
    }));
    const tolerant = newcomer.tolerance !== null || swarm.robots.some(({ tolerance }) => tolerance !== null);
    show(this.#poses.node, tolerant || criterion.worst_case);
    this.#poses.draw(criterion.worst_case ? "worst poses" : "poses exact", criterion.worst_case, "Where the robots may really be",
      () => this.context.store.editProblem((now) => ({ ...now, criterion: { ...now.criterion, worst_case: !now.criterion.worst_case } })));
  }

  #drawWeather(doc: Doc): void {
    const { environment } = doc;
    const blows = doc.in_weather && environment !== null;
    show(this.#weather.node, environment !== null);
    this.#weather.draw(blows ? "in wind" : "no wind", blows, "Weather", () => this.toggleWind());
    const speech = this.context.speech.value;
    const { size, label } = speech.data.speed;
    const speed = (spin: Spin, blow: BlowData | null, what: "wind" | "current", shown: boolean): void => {
      show(spin.node, shown);
      if (!shown) return;
      const step = what === "wind" ? (size < 0.2 ? 1 : label === "m/s" && (blow!.speed ?? 0) < 5 ? 0.1 : 1) : 0.1;
      spin.draw((blow!.speed ?? 0) / size, this.#spin({
        label: what === "wind" ? "Speed of the wind" : "Speed of the current", min: 0, max: 400, step,
        text: (value) => `${figure(value)}\u00a0${label}`,
        change: (value, moving) => this.#blow(what, { speed: value * size }, moving),
      }));
    };
    const bearing = (spin: Spin, blow: BlowData | null, what: "wind" | "current", shown: boolean): void => {
      show(spin.node, shown);
      if (!shown) return;
      const told = (speech.told(blow!.bearing ?? environment!.wind.bearing ?? 0)) / DEGREE;
      spin.draw(Math.round(told * 10) / 10, this.#spin({
        label: `Where the ${what} comes from`, min: 0, max: 360, step: 1, wraps: true,
        text: (value) => `${String(Math.round(value) % 360).padStart(3, "0")}°`,
        change: (value, moving) => this.#blow(what, { bearing: value * DEGREE - (speech.data.heading ?? 0) }, moving),
      }));
    };
    const current = environment?.current ?? null;
    speed(this.wind, environment?.wind ?? null, "wind", blows);
    bearing(this.#from, environment?.wind ?? null, "wind", blows);
    speed(this.#current, current, "current", blows && current !== null);
    bearing(this.#currentFrom, current, "current", blows && current !== null && current.bearing !== null);
    write(this.#words.from, "from");
    show(this.#words.from, blows);
    write(this.#words.current, "current");
    show(this.#words.current, blows && current !== null);
    write(this.#words.currentFrom, "from");
    show(this.#words.currentFrom, blows && current !== null && current.bearing !== null);
  }

  /** Into the weather, with a wind to begin with where there is none, and out of it. */
  toggleWind(): void {
    this.context.store.edit((doc) => {
      if (doc.environment === null) return doc;
      if (doc.in_weather) return { ...doc, in_weather: false };
      const { wind } = doc.environment;
      const blows = { ...wind, speed: wind.speed ?? WIND.speed, bearing: wind.bearing ?? WIND.bearing };
      return { ...doc, in_weather: true, environment: { ...doc.environment, wind: blows } };
    });
  }

  #blow(what: "wind" | "current", change: Partial<BlowData>, moving: boolean): void {
    this.context.store.edit((doc) => {
      const environment = doc.environment as EnvironmentData;
      return { ...doc, environment: { ...environment, [what]: { ...environment[what]!, ...change } } };
    }, moving);
  }

  #drawNewcomer(doc: Doc): void {
    const { newcomer } = doc.problem;
    const { store } = this.context;
    const name = newcomer.name || "the newcomer";
    this.#comes.draw(doc.newcomer ? name : "nobody comes", doc.newcomer, "Who comes",
      () => store.edit((one) => ({ ...one, newcomer: !one.newcomer })));
    write(this.#words.brings, "brings");
    const unit = this.context.speech.value.forceUnit(newcomer.limit);
    for (const node of [this.#words.brings, this.#limit.node, this.#words.then, this.#later.node, this.#words.more]) show(node, doc.newcomer);
    this.#limit.draw(newcomer.limit / unit.size, this.#spin({
      label: `Limit of ${name}`, min: Number.MIN_VALUE, max: Infinity, step: stepOf(newcomer.limit / unit.size),
      text: (value) => `${figure(value)}\u00a0${unit.label}`,
      change: (value, moving) => store.editNewcomer((one) => ({ ...one, limit: value * unit.size }), moving),
    }));
    write(this.#words.then, "then");
    write(this.#words.more, "more");
    this.#later.draw(this.later.count, {
      label: "How many more come after it", min: 0, max: MOST_LATER, step: 1, text: String,
      change: (count) => this.later.set(count, this.later.together), settle: () => undefined,
    });
    show(this.#together.node, doc.newcomer && this.later.count > 0);
    this.#together.draw(this.later.together ? "together" : "one by one", this.later.together, "How they are placed",
      () => this.later.set(this.later.count, !this.later.together));
    put(this.name, { "aria-label": `${doc.name}: scenes and files` });
  }
}

/** A step for numbers of a size: 1 from 10 on, else a tenth of their power of ten. */
export function stepOf(value: number): number {
  return value >= 10 ? 1 : 10 ** (Math.floor(Math.log10(Math.max(value, 1e-6))) - 1);
}
