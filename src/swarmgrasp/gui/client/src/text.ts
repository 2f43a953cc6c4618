/* The scenario as text: what is drawn is written, what is typed is drawn, faults stand at their line. */

import type { Context, Seen, View } from "./context";
import { el, put, show, write } from "./dom";
import type { Doc, Fault, Scene } from "./messages";

const PAUSE = 150;
/** A text that is read for so long is said to be read [ms]. */
const SLOW = 400;
/** Height of a line [px]. */
const LINE = 18;

export class TextPane implements View {
  readonly #where = el("span", { class: "text-where" });
  readonly #list = el("div", { class: "text-faults", role: "status" });
  readonly #numbers = el("div");
  readonly #gutter = el("div", { class: "text-gutter", "aria-hidden": "true" }, this.#numbers);
  readonly #painted = el("div");
  readonly #paint = el("pre", { class: "text-paint", "aria-hidden": "true" }, this.#painted);
  readonly source = el("textarea", { class: "text-source", spellcheck: "false", wrap: "off", "aria-label": "Scenario as YAML", autocapitalize: "off" });
  #faults: readonly Fault[] = [];
  #lines: readonly string[] = [];
  #frame = 0;
  #shown: { doc: Doc; scene: Scene } | null = null;
  #timer = 0;
  #asked = 0;
  #sending = false;

  constructor(readonly card: HTMLElement, readonly context: Context, readonly read: (scene: Scene) => void) {
    card.append(
      el("div", { class: "tile-head" }, el("h2", { class: "tile-title" }, "Scenario"), this.#where), this.#list,
      el("div", { class: "text-box" }, this.#gutter, el("div", { class: "text-area" }, this.#paint, this.source)),
    );
    this.source.addEventListener("input", () => this.#typed());
    this.source.addEventListener("scroll", () => this.#draw());
    new ResizeObserver(() => this.#draw()).observe(this.source);
    this.source.addEventListener("keydown", (event) => this.#key(event));
    this.source.addEventListener("blur", () => context.store.settle());
  }

  get isOpen(): boolean {
    return !this.card.hidden;
  }

  get #typing(): boolean {
    return this.source.matches(":focus");
  }

  toggle(losses: HTMLElement): void {
    show(this.card, !this.isOpen);
    show(losses, !this.isOpen);
    if (!this.isOpen) return;
    this.#shown = null;
    const seen = this.context.store.seen.value;
    if (seen !== null) this.draw(seen);
    this.source.focus();
  }

  draw(seen: Seen): void {
    if (!this.isOpen || (this.#typing && this.#shown !== null)) return;
    if (seen.moving || (this.#shown?.doc === seen.doc && this.#shown.scene === seen.scene)) return;
    this.#shown = { doc: seen.doc, scene: seen.scene };
    if (seen.doc === seen.scene.doc) {
      this.#set(seen.scene.text);
      return;
    }
    const asked = ++this.#asked;
    void this.text().then((text) => {
      if (text !== null && asked === this.#asked && !this.#typing) this.#set(text);
    });
  }

  /** The text of what is on the page. */
  async text(): Promise<string | null> {
    const seen = this.context.store.seen.value;
    if (seen === null) return null;
    if (seen.doc === seen.scene.doc) return seen.scene.text;
    const reply = await this.context.talk.request({ kind: "write", doc: seen.doc, text: seen.scene.text });
    if (reply.kind === "text") return reply.text;
    const why = reply.kind === "error" ? reply.say : reply.kind === "refused" ? reply.faults[0]?.sentence : undefined;
    this.context.toast(why ?? "This cannot be written as a scenario.");
    return null;
  }

  #set(text: string): void {
    const { scrollTop } = this.source;
    if (this.source.value !== text) this.source.value = text;
    this.source.scrollTop = scrollTop;
    this.#tell([]);
    this.#colour();
  }

  #typed(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#colour());
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => void this.#send(), PAUSE);
  }

  /** Sends what stands there, one text at a time, and the newest next. */
  async #send(): Promise<void> {
    const seen = this.context.store.seen.value;
    if (seen === null || this.#sending) return;
    const text = this.source.value;
    this.#sending = true;
    const slow = window.setTimeout(() => {
      write(this.#where, "reading…");
      put(this.#where, { "data-calm": true });
    }, SLOW);
    const reply = await this.context.talk.request({ kind: "text", text, name: seen.scene.name });
    clearTimeout(slow);
    this.#sending = false;
    if (this.source.value !== text) return this.#send();
    if (reply.kind === "faults") this.#tell(reply.faults);
    else if (reply.kind === "error") this.#tell([{ line: null, column: null, path: "", sentence: reply.say }]);
    else if (reply.kind === "scene") {
      this.#tell([]);
      const now = this.context.store.draft;
      if (now !== null && now.scene.text === text && now.doc === now.scene.doc) return;
      this.read(reply);
      this.#shown = { doc: reply.doc, scene: reply };
    }
  }

  #tell(faults: readonly Fault[]): void {
    this.#faults = faults;
    const first = faults[0];
    put(this.#where, { "data-calm": null });
    write(this.#where, first?.line == null ? "" : `line ${first.line}, column ${first.column ?? 1}`);
    put(this.source, { "aria-invalid": faults.length > 0 ? "true" : null });
    this.#list.replaceChildren(...faults.map((fault) => {
      const words = `${fault.path === "" ? "" : `${fault.path}: `}${fault.sentence}`;
      const item = el("button", { type: "button", class: "text-fault" }, words);
      item.addEventListener("click", () => this.#goTo(fault));
      return item;
    }));
    this.#colour();
  }

  #goTo(fault: Fault): void {
    if (fault.line === null) return;
    const lines = this.source.value.split("\n");
    const before = lines.slice(0, fault.line - 1).reduce((sum, line) => sum + line.length + 1, 0);
    const at = before + Math.max(0, (fault.column ?? 1) - 1);
    this.source.focus();
    this.source.setSelectionRange(at, at);
    this.source.scrollTop = Math.max(0, (fault.line - 5) * LINE);
  }

  #key(event: KeyboardEvent): void {
    if (event.key === "Tab" && !event.shiftKey) {
      event.preventDefault();
      this.source.setRangeText("  ", this.source.selectionStart, this.source.selectionEnd, "end");
      this.#typed();
    } else if (event.key === "Escape") {
      this.source.blur();
      event.preventDefault();
    }
    event.stopPropagation();
  }

  #colour(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#lines = this.source.value.split("\n");
    this.#gutter.style.minWidth = `calc(${String(this.#lines.length).length}ch + 12px)`;
    this.#draw();
  }

  /** The lines in view: keys in the colour of robots, comments grey, those with faults underlined. */
  #draw(): void {
    const { scrollTop, scrollLeft, clientHeight } = this.source;
    const first = Math.floor(scrollTop / LINE);
    const bad = new Set(this.#faults.map(({ line }) => line));
    const lines = this.#lines.slice(first, first + Math.ceil(clientHeight / LINE) + 1);
    const isBad = (i: number): boolean => bad.has(first + i + 1);
    this.#painted.replaceChildren(...lines.map((line, i) => painted(line, isBad(i))));
    this.#numbers.replaceChildren(...lines.map((_, i) => el("div", { class: isBad(i) ? "bad" : null }, String(first + i + 1))));
    const down = first * LINE - scrollTop;
    this.#painted.style.transform = `translate(${-scrollLeft}px, ${down}px)`;
    this.#numbers.style.transform = `translateY(${down}px)`;
  }
}

const PIECES = /(#.*$)|([\w"'-][\w "'-]*:)(?=\s|$)/g;

function painted(line: string, bad: boolean): HTMLElement {
  const row = el("div", { class: bad ? "line bad" : "line" });
  let at = 0;
  for (const match of line.matchAll(PIECES)) {
    if (match[1] !== undefined && match.index > 0 && !/\s/.test(line[match.index - 1]!)) continue;
    row.append(line.slice(at, match.index), el("span", { class: match[1] === undefined ? "yaml-key" : "yaml-comment" }, match[0]));
    at = match.index + match[0].length;
  }
  row.append(`${line.slice(at)}\n`);
  return row;
}
