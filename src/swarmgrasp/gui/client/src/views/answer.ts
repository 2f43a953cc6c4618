/* The answer in words: a verdict, an order, figures, facts, and what comes next. */

import type { Context, Seen, View } from "../context";
import { el, Pool, put, show, write } from "../dom";
import type { AnswerPart, CapabilityPart, Fact, Fault, Figure, NextPlace, Placed, ProofPart, RobotData } from "../messages";
import { keepNewcomer } from "../keeping";
import type { Later } from "../sequence";
import { figure } from "../speech";

/** How long the hand must rest before the verdict is spoken [ms]. */
const REST = 400;

export class Answer implements View {
  readonly #context: Context;
  readonly #refusal: Pool<HTMLElement, Fault>;
  readonly #figures: Pool<HTMLElement, Figure>;
  readonly #facts: Pool<HTMLElement, Fact>;
  readonly #next: Pool<HTMLElement, NextPlace>;
  readonly #later: Pool<HTMLElement, Placed>;
  readonly #sequence: Later;
  readonly #nodes;
  #drawn: readonly unknown[] = [];
  #spoken = "";
  #timer = 0;

  constructor(root: HTMLElement, context: Context, later: Later) {
    this.#context = context;
    this.#sequence = later;
    const nodes = {
      refusal: el("ul", { class: "refusal", role: "alert" }),
      told: el("div", { class: "told" }),
      first: el("h1", { class: "first" }),
      second: el("p", { class: "second" }),
      order: el("div", { class: "order" }),
      who: el("span", { class: "who" }),
      place: el("span", { class: "place" }),
      contact: el("span", { class: "contact" }),
      what: el("p", { class: "what" }),
      later: el("div", { class: "later-orders" }),
      laterTitle: el("h2", { class: "tile-title" }),
      laterSaid: el("p", { class: "why" }),
      laterList: el("ol", {}),
      figures: el("div", { class: "figures" }),
      facts: el("dl", { class: "facts" }),
      next: el("div", { class: "next" }),
      places: el("ul", {}),
    };
    this.#nodes = nodes;
    const arrow = el("span", { class: "leads", role: "img", "aria-label": "to" }, "→");
    const line = el("p", { class: "go" }, nodes.who, " ", arrow, " ", nodes.place);
    nodes.order.append(el("div", { class: "order-line" }, line, nodes.contact), nodes.what);
    nodes.next.append(el("h2", { class: "tile-title" }, "Next best"), nodes.places);
    nodes.later.append(nodes.laterTitle, nodes.laterList, nodes.laterSaid);
    nodes.told.append(nodes.order, nodes.later, nodes.figures, nodes.facts, nodes.next);
    root.replaceChildren(nodes.refusal, nodes.first, nodes.second, nodes.told);
    this.#refusal = new Pool(nodes.refusal, (): HTMLElement => el("li"), (node, fault: Fault) => write(node, fault.sentence));
    this.#figures = new Pool(nodes.figures, makeFigure, dressFigure);
    this.#facts = new Pool(nodes.facts, makeFact, (node, fact: Fact) => this.#dressFact(node, fact));
    this.#next = new Pool(nodes.places, makeNext, (node, next: NextPlace) => this.#dressNext(node, next));
    this.#later = new Pool(nodes.laterList, makeLater, dressLater);
    this.#linkHover();
    nodes.places.addEventListener("click", (event) => {
      const robot = this.#nextAt(event);
      if (robot !== null) keepNewcomer(context, robot);
    });
  }

  draw(seen: Seen): void {
    const { answer, capability, proof } = seen.parts;
    const inputs = [answer, capability, proof, this.#sequence.answers, this.#sequence.together, seen.refused, seen.moving, this.#context.speech.value, seen.empty.answer];
    if (inputs.every((input, i) => input === this.#drawn[i])) return;
    this.#drawn = inputs;
    this.#refusal.draw(seen.refused);
    show(this.#nodes.refusal, seen.refused.length > 0);
    put(this.#nodes.told.parentElement!, { "data-refused": seen.refused.length > 0 });
    show(this.#nodes.told, answer !== undefined);
    if (answer === undefined) {
      write(this.#nodes.first, "");
      write(this.#nodes.second, seen.empty.answer ?? "");
      return;
    }
    this.#tell(answer, capability, proof);
    if (!seen.moving) this.#speak(answer);
  }

  #tell(answer: AnswerPart, capability: CapabilityPart | undefined, proof: ProofPart | undefined): void {
    const nodes = this.#nodes;
    const speech = this.#context.speech.value;
    write(nodes.first, answer.first.text);
    put(nodes.first, { class: answer.first.good ? "first good" : "first bad" });
    write(nodes.second, answer.second);
    const { order } = answer;
    show(nodes.order, order !== null);
    if (order !== null) {
      write(nodes.who, order.name);
      write(nodes.place, order.place);
      write(nodes.contact, speech.point(order.contact));
      write(nodes.what, order.do);
    }
    this.#tellLater(order !== null);
    this.#figures.draw(capability === undefined ? answer.figures : [...answer.figures, capability.figure]);
    this.#facts.draw(answer.facts.map((fact) => proved(fact, proof)));
    put(nodes.facts, { "data-proof": proof === undefined ? "open" : proof.ok ? "ok" : "failed" });
    show(nodes.facts, answer.facts.length > 0);
    this.#next.draw(answer.next);
    show(nodes.next, answer.next.length > 0);
  }

  /** Those that come after the first; of those placed together all. */
  #tellLater(comes: boolean): void {
    const { answers, together, said } = this.#sequence;
    const told = together ? answers : answers.slice(1);
    show(this.#nodes.later, comes && told.length > 0);
    write(this.#nodes.laterTitle, together ? "Placed together instead" : "Then");
    write(this.#nodes.laterSaid, said);
    this.#later.draw(together ? told.map((one) => ({ ...one, text: "" })) : told); // all have the same
  }

  #dressFact(node: HTMLElement, fact: Fact): void {
    put(node, { "data-mark": fact.mark, "data-names": fact.names.join("\n") });
    write(node.firstElementChild!, fact.label);
    write(node.lastElementChild!, fact.text);
  }

  #dressNext(node: HTMLElement, next: NextPlace): void {
    const button = node.firstElementChild!;
    const [place, value, share] = button.children;
    const { newcomer } = this.#context.store.seen.value!.doc.problem;
    put(button, { title: `Put ${newcomer.name || "the newcomer"} there` });
    write(place!, next.place);
    write(value!, next.text);
    write(share!, `${Math.round(100 * next.share)}\u00a0%`);
  }

  /** A row shows where it is in the plan, and who is hovered there is marked here. */
  #linkHover(): void {
    const { hover, store } = this.#context;
    const places = this.#nodes.places;
    for (const kind of ["pointerover", "focusin"]) {
      places.addEventListener(kind, (event) => {
        const robot = this.#nextAt(event);
        const value = store.seen.value?.parts.answer?.next[this.#rowAt(event)]?.value ?? null;
        if (robot !== null) hover.set({ kind: "place", robot, value });
      });
    }
    for (const kind of ["pointerleave", "focusout"]) places.addEventListener(kind, () => hover.set(null));
    hover.listen((hovered) => {
      const name = hovered?.kind === "robot" ? hovered.name : null;
      for (const fact of this.#facts.nodes) {
        const names = fact.getAttribute("data-names")?.split("\n") ?? [];
        put(fact, { "data-hovered": name !== null && names.includes(name) });
      }
      const zone = hovered?.kind === "zone" ? hovered.name : null;
      for (const row of this.#next.nodes) {
        put(row, { "data-hovered": zone !== null && row.querySelector(".place")?.textContent === zone });
      }
    });
  }

  /** The number of the row of another place that an event is in; -1 where it is in none. */
  #rowAt(event: Event): number {
    const row = (event.target as Element).closest("li");
    return row === null ? -1 : [...this.#nodes.places.children].indexOf(row);
  }

  /** The newcomer in the place of a row. */
  #nextAt(event: Event): RobotData | null {
    const answer = this.#context.store.seen.value?.parts.answer;
    const next = answer?.next[this.#rowAt(event)];
    if (next === undefined || answer?.newcomer == null) return null;
    return { ...answer.newcomer, contact: next.contact, direction: next.direction };
  }

  /** The verdict and the order, for those who hear the page, once the hand rests. */
  #speak(answer: AnswerPart): void {
    clearTimeout(this.#timer);
    const order = answer.order;
    const go = order === null ? "" : ` ${order.name} to ${order.place}. ${order.do}.`;
    const sentence = `${answer.first.text}, ${answer.second}.${go}`;
    if (sentence === this.#spoken) return;
    this.#timer = window.setTimeout(() => {
      this.#spoken = sentence;
      this.#context.say(sentence);
    }, REST);
  }
}

/** The fact of the proof, with what checking it found where that failed. */
function proved(fact: Fact, proof: ProofPart | undefined): Fact {
  const failed = fact.mark === "proven" && proof !== undefined && !proof.ok;
  return failed ? { ...fact, label: "Not proven", text: proof.text } : fact;
}

function makeFigure(): HTMLElement {
  const value = el("p", { class: "figure" },
    el("span", { class: "before" }), el("span", { class: "arrow", role: "img", "aria-label": "to" }, "→"),
    el("span", { class: "after" }), el("span", { class: "unit" }));
  return el("div", {}, value, el("p", { class: "what-it-is" }));
}

function dressFigure(node: HTMLElement, { before, after, unit, text }: Figure): void {
  const [was, arrow, is, of] = node.firstElementChild!.children;
  write(was!, before === null ? "" : figure(before));
  show(was as HTMLElement, before !== null);
  show(arrow as HTMLElement, before !== null);
  write(is!, figure(after));
  write(of!, unit);
  write(node.lastElementChild!, text);
}

function makeFact(): HTMLElement {
  return el("div", { class: "fact" }, el("dt"), el("dd"));
}

function makeLater(): HTMLElement {
  const line = el("p", { class: "later-go" }, el("b"), el("span", { role: "img", "aria-label": "to" }, " → "), el("span"), el("span", { class: "value" }));
  return el("li", {}, line, el("p", { class: "later-what" }));
}

function dressLater(node: HTMLElement, { newcomer, place, do: what, text }: Placed): void {
  const [name, , where, value] = node.firstElementChild!.children;
  write(name!, newcomer.name || "newcomer");
  write(where!, place);
  write(value!, text);
  write(node.lastElementChild!, what);
}

function makeNext(): HTMLElement {
  return el("li", {}, el("button", { type: "button" },
    el("span", { class: "place" }), el("span", { class: "value" }), el("span", { class: "share" })));
}
