/* The whole widget, in one element, over one wire. Nothing is kept outside of what `mount` makes. */

import { Banner } from "./banner";
import { Bar } from "./bar";
import type { Context, Seen, View } from "./context";
import { el } from "./dom";
import { Inspector } from "./inspect";
import { hearKeys } from "./keys";
import { layout } from "./layout";
import { Menu } from "./menu";
import { Opening } from "./opening";
import { Plan } from "./plan/plan";
import { Later } from "./sequence";
import { keysCard, Sheet } from "./sheet";
import { Signal } from "./signal";
import { SILENT, Speech } from "./speech";
import { Store } from "./state";
import { Talk } from "./talk";
import { TextPane } from "./text";
import { themed } from "./theme";
import { Tools } from "./tools";
import { views } from "./views";
import type { Wire } from "./wire";

/** What differs between a page and a notebook. */
export interface Home {
  /** Where changes are kept; null where nothing is. */
  readonly storage: Storage | null;
  /** The key that opens the socket. */
  readonly key: () => string;
  /** The text of the scenario that the page's link carries, or null. */
  readonly linked: () => Promise<string | null>;
  /** Told when the hand rests and all is answered. */
  readonly answered?: (n: number) => void;
}

/** Builds the widget in an element and lets it live there. */
export function mount(root: HTMLElement, wire: Wire, home: Home): Context {
  const frame = layout(root);
  root.classList.add("is-empty");
  const store = new Store();
  const talk = new Talk(wire, home.key);
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const context: Context = {
    root, store, talk,
    hover: store.hover,
    speech: new Signal(new Speech(SILENT)),
    calm: () => calm.matches,
    say: (sentence) => frame.spoken.replaceChildren(sentence),
    toast: (sentence, action) => toast(frame.toasts, sentence, action),
  };
  const opening = new Opening(context, home.storage);
  const sheet = new Sheet(frame.over);
  const plan = new Plan(frame.plan, context);
  const painter = new Painter(context);
  const later = new Later(context, () => painter.ask());
  const inspector = new Inspector(plan, context);
  const tools = new Tools(plan, context);
  const text = new TextPane(frame.text, context, (scene) => store.read(scene, true));
  const menu = new Menu(context, sheet, {
    open: (name) => void opening.open(name),
    read: (source, name) => void opening.read(source, name),
    plan: () => plan.svg,
    text: () => text.text(),
  });
  const toggleText = (): void => {
    text.toggle(frame.losses.card);
    bar.textButton.setAttribute("aria-pressed", String(text.isOpen));
  };
  const showKeys = (): void => sheet.open(keysCard(() => sheet.close()));
  const bar = new Bar(frame.bar, context, later, {
    menu: () => menu.show(bar.name), text: toggleText, theme: themed(root, home.storage), keys: showKeys,
    share: () => void menu.share(),
  });
  const followers: View[] = [new Banner(frame.banner, context), bar, plan, inspector, tools, plan.names, text];
  painter.views = [...followers, ...views(frame, context, plan.layer, later)];
  painter.before = (seen) => {
    later.follow(seen);
    const robots = later.answers.map(({ newcomer }) => newcomer);
    plan.later = later.count > 0 ? robots.slice(1) : [];
    plan.together = later.count > 0 && later.together ? robots[0] ?? null : null;
  };
  hearKeys(context, {
    bar, inspector, menu, plan, sheet, tools, toggleText, textIsOpen: () => text.isOpen, showKeys,
  });
  store.ask = ({ scene, doc }, moving) => {
    plan.push.ask();
    painter.owed = true;
    painter.ask();
    return talk.ask(doc, scene.speech, moving);
  };
  store.seen.listen(() => painter.ask());
  talk.connected.listen((connected) => store.setConnected(connected));
  talk.exchanged = () => painter.ask();
  talk.hear = (message) => {
    if (message.kind === "welcome") {
      void opening.first(message.opens, home.linked);
      return;
    }
    if (message.kind === "error" && message.n === null) context.toast(message.say);
    store.take(message);
    if (message.kind === "part" && message.name === "answer") painter.mark("answered", message.n);
    if (message.kind === "done" || message.kind === "refused") painter.mark("done", message.n);
    if (message.kind === "done" || message.kind === "refused" || message.kind === "error") {
      if (talk.idle) painter.owed = false;
      painter.ask();
      if (talk.idle && message.kind === "done" && store.seen.value?.moving === false) home.answered?.(message.n);
    }
  };
  return context;
}

/**
 * Draws once a frame, however often the state changed. The root bears `data-busy` from the moment
 * that something is asked or changes until all of it is painted.
 */
class Painter {
  views: View[] = [];
  before: (seen: Seen) => void = () => undefined;
  /** Whether something that was asked is not wholly answered. */
  owed = false;
  #asked = 0;
  readonly #marks = new Map<string, number>();

  constructor(readonly context: Context) {}

  ask(): void {
    this.context.root.dataset.busy = "";
    if (this.#asked === 0) this.#asked = requestAnimationFrame(() => this.#draw());
  }

  /** For tests and benchmarks: which ask is answered, and in all its parts, on the screen. */
  mark(name: "answered" | "done", n: number): void {
    this.#marks.set(name, n);
    this.ask();
  }

  #draw(): void {
    this.#asked = 0;
    const { store, speech, root } = this.context;
    const seen = store.seen.value;
    if (seen === null) return;
    if (speech.value.data !== seen.scene.speech) speech.set(new Speech(seen.scene.speech));
    root.classList.remove("is-empty");
    this.before(seen);
    for (const view of this.views) view.draw(seen);
    root.classList.toggle("is-refused", seen.refused.length > 0);
    for (const [name, n] of this.#marks) root.setAttribute(`data-${name}`, String(n));
    this.#marks.clear();
    if (!this.owed && this.#asked === 0 && this.context.talk.replied) delete root.dataset.busy;
  }
}

const TOAST_STAYS = 6000;

/** A sentence that goes with the first thing that is done after a while: none goes unseen. */
function toast(room: HTMLElement, sentence: string, action?: { word: string; run: () => void }): void {
  const root = room.parentElement!;
  const card = el("div", { class: "toast" }, el("span", {}, sentence));
  const away = (): void => {
    card.remove();
    for (const kind of ["pointerdown", "keydown"]) root.removeEventListener(kind, away);
  };
  if (action !== undefined) {
    const button = el("button", { type: "button", class: "control" }, action.word);
    button.addEventListener("click", () => {
      away();
      action.run();
    });
    card.append(button);
  }
  room.replaceChildren(card);
  window.setTimeout(() => {
    for (const kind of ["pointerdown", "keydown"]) root.addEventListener(kind, away);
  }, TOAST_STAYS);
}
