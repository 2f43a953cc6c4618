/* The whole widget, in one element, over one wire. Nothing is kept outside of what `mount` makes. */

import { Autosave } from "./autosave";
import type { Context, Seen, View } from "./context";
import { el } from "./dom";
import { layout } from "./layout";
import type { Doc, Incoming, Scene } from "./messages";
import { Signal } from "./signal";
import { Speech } from "./speech";
import { Store } from "./state";
import { Talk } from "./talk";
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
}

const REST = 300;
const SI_SPEECH = new Speech({
  length: { unit: "m", size: 1 }, force: { unit: "N", size: 1 },
  angle: { unit: "°", size: Math.PI / 180 }, speed: { unit: "m/s", size: 1 },
  torque_unit: "N m", robot: "robot", bow: 0, mirrored: false, heading: null, bearings: false,
});

/** Builds the widget in an element and lets it live there. */
export function mount(root: HTMLElement, wire: Wire, home: Home): Context {
  const frame = layout(root);
  const store = new Store();
  const talk = new Talk(wire, home.key);
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const context: Context = {
    root, store, talk,
    hover: store.hover,
    speech: new Signal(SI_SPEECH),
    calm: () => calm.matches,
    say: (sentence) => frame.spoken.replaceChildren(sentence),
    toast: (sentence, action) => toast(frame.toasts, sentence, action),
  };
  const drawn: View[] = views(frame, context);
  const painter = new Painter(root, drawn, context);
  store.seen.listen((seen) => painter.ask(seen));
  store.ask = (doc, moving) => talk.ask(doc, moving);
  talk.connected.listen((connected) => store.setConnected(connected));
  keepChanges(context, new Autosave(home.storage), home, painter);
  return context;
}

/** Draws once a frame, however often the state changed. */
class Painter {
  #asked = 0;

  constructor(readonly root: HTMLElement, readonly views: View[], readonly context: Context) {}

  ask(seen: Seen | null): void {
    if (seen === null) return;
    if (this.context.speech.value.data !== seen.scene.speech) {
      this.context.speech.set(new Speech(seen.scene.speech));
    }
    if (this.#asked === 0) this.#asked = requestAnimationFrame(() => this.draw());
  }

  draw(): void {
    this.#asked = 0;
    const seen = this.context.store.seen.value;
    if (seen === null) return;
    for (const view of this.views) view.draw(seen);
  }

  /** For tests and benchmarks: which ask is answered, and in all its parts. */
  mark(name: "answered" | "done", n: number): void {
    requestAnimationFrame(() => this.root.setAttribute(`data-${name}`, String(n)));
  }
}

/** Takes what the server says, opens scenes, and keeps changes from one visit to the next. */
function keepChanges(context: Context, saved: Autosave, home: Home, painter: Painter): void {
  const { store, talk } = context;
  let timer = 0;
  const opened = (scene: Scene): void => {
    const kept = saved.kept(scene.name, scene.text);
    store.open(scene, kept ?? scene.doc);
    if (kept !== null) {
      context.toast("Your changes are back.", {
        word: "Start over",
        run: () => {
          saved.forget(scene.name, true);
          store.edit(() => scene.doc);
        },
      });
    }
  };
  store.seen.listen((seen) => {
    if (seen === null) return;
    clearTimeout(timer);
    timer = window.setTimeout(() => keep(seen.scene, seen.doc), REST);
  });
  const keep = (scene: Scene, doc: Doc): void => {
    if (doc === scene.doc) saved.forget(scene.name);
    else if (!saved.keep(scene.name, scene.text, doc)) {
      context.say("The browser has no room to keep your changes; save them as a file.");
    }
  };
  const first = async (opens: string): Promise<void> => {
    const text = await home.linked().catch(() => {
      context.toast("The link's scenario cannot be read.");
      return null;
    });
    const reply = await talk.request(
      text === null ? { kind: "open", name: opens } : { kind: "text", text, name: "link" },
    );
    if (reply.kind === "scene") opened(reply);
    else if (reply.kind === "error") context.toast(reply.say);
    else if (reply.kind === "faults") context.toast("The link's scenario has faults.");
  };
  talk.hear = (message: Incoming) => {
    if (message.kind === "welcome") {
      if (store.seen.value === null) void first(message.opens);
      return;
    }
    store.take(message);
    if (message.kind === "part" && message.name === "answer") painter.mark("answered", message.n);
    if (message.kind === "done" || message.kind === "refused") painter.mark("done", message.n);
  };
}

const TOAST_STAYS = 6000;

function toast(room: HTMLElement, sentence: string, action?: { word: string; run: () => void }): void {
  const card = el("div", { class: "toast" }, el("span", {}, sentence));
  const away = (): void => card.remove();
  if (action !== undefined) {
    const button = el("button", { type: "button" }, action.word);
    button.addEventListener("click", () => {
      away();
      action.run();
    });
    card.append(button);
  }
  room.replaceChildren(card);
  window.setTimeout(away, TOAST_STAYS);
}
