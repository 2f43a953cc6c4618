/* The studio as an anywidget: over the comm of a notebook's kernel, in a shadow root of its own. */

import light from "../fonts/inter-400.woff2";
import heavy from "../fonts/inter-600.woff2";
import styles from "styles";
import { mount } from "./app";
import { Signal } from "./signal";
import type { Wire } from "./wire";

/** What anywidget gives of a model. */
interface Model {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  save_changes(): void;
  on(name: string, hear: (content: unknown, buffers: readonly (DataView | ArrayBuffer)[]) => void): void;
  off(name: string, hear: (content: unknown, buffers: readonly (DataView | ArrayBuffer)[]) => void): void;
  send(content: unknown, callbacks?: unknown, buffers?: readonly ArrayBuffer[]): void;
}

/** JSON goes as the content of a custom message, a binary frame as its only buffer. */
class CommWire implements Wire {
  readonly up = new Signal(true);
  readonly refusal = new Signal<string | null>(null);
  hear: (data: string | ArrayBuffer) => void = () => undefined;

  constructor(readonly model: Model) {
    model.on("msg:custom", this.#take);
  }

  readonly #take = (content: unknown, buffers: readonly (DataView | ArrayBuffer)[] = []): void => {
    const [frame] = buffers;
    this.hear(frame === undefined ? JSON.stringify(content) : bytesOf(frame));
  };

  send(data: string | ArrayBuffer): void {
    if (typeof data === "string") this.model.send(JSON.parse(data));
    else this.model.send({}, undefined, [data]);
  }

  retry(): void {
    this.up.set(true);
  }

  close(): void {
    this.model.off("msg:custom", this.#take);
  }
}

/** A frame of its own, so that its arrays lie at multiples of 8 bytes. */
function bytesOf(frame: DataView | ArrayBuffer): ArrayBuffer {
  if (frame instanceof ArrayBuffer) return frame;
  return new Uint8Array(frame.buffer, frame.byteOffset, frame.byteLength).slice().buffer as ArrayBuffer;
}

/** The typeface, once in a document: a shadow root does not hear of @font-face. */
function setType(document: Document): void {
  for (const [weight, bytes] of [["400", light], ["600", heavy]] as const) {
    const known = [...document.fonts].some((face) => face.family === "Inter" && face.weight === weight);
    if (!known) document.fonts.add(new FontFace("Inter", bytes, { weight }));
  }
}

const HEIGHT = 720;

/** Keys of the page are not those of the notebook, where "x" would cut the cell that the page is in. */
function keepKeys(host: HTMLElement): void {
  host.dataset.lmSuppressShortcuts = "true"; // JupyterLab looks at this first
  host.addEventListener("keydown", (event) => {
    if (!event.ctrlKey && !event.metaKey && !event.altKey) event.stopPropagation();
  });
}

function render({ model, el: place }: { model: Model; el: HTMLElement }): () => void {
  const document = place.ownerDocument;
  setType(document);
  const host = document.createElement("div");
  const shadow = host.attachShadow({ mode: "open" });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(styles);
  shadow.adoptedStyleSheets = [sheet];
  const root = document.createElement("div");
  root.dataset.home = "notebook";
  root.style.setProperty("--height", `${Number(model.get("height") ?? HEIGHT)}px`);
  shadow.append(root);
  place.append(host);
  keepKeys(host);
  const wire = new CommWire(model);
  mount(root, wire, {
    storage: null, key: () => "", linked: async () => null,
    answered: (n) => { // marimo runs the cells that look at a widget again when its page changes something
      model.set("answered", n);
      model.save_changes();
    },
  });
  return () => wire.close();
}

export default { render };
