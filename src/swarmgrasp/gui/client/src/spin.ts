/* A number in a sentence that is its own control: drag it sideways, arrows, digits and Enter. */

import { el, put, show, write } from "./dom";

export interface SpinOptions {
  readonly label: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** Whether it goes on at the other end. */
  readonly wraps?: boolean;
  readonly text: (value: number) => string;
  /** A value was set; `moving` while a hand still holds it. */
  readonly change: (value: number, moving: boolean) => void;
  /** The hand let go. */
  readonly settle: () => void;
  /** What stands behind the number, in the same box. */
  readonly after?: string;
}

const PIXELS = 6;
const FEW = 5;
const BIG = 10;

export class Spin {
  readonly node = el("span", { class: "control spin", role: "spinbutton", tabindex: 0 });
  readonly #text = el("span", { class: "spin-text" });
  readonly #after = el("span", { class: "spin-after" });
  #options: SpinOptions | null = null;
  #drawn = 0;
  /** What it stands at: a key that comes before the frame goes on from here. */
  #value = 0;
  #from: { x: number; value: number; moved: boolean } | null = null;
  #typing: HTMLInputElement | null = null;
  #stepped = false;

  constructor() {
    this.node.append(this.#text, this.#after);
    this.node.addEventListener("pointerdown", (event) => this.#down(event));
    this.node.addEventListener("pointermove", (event) => this.#move(event));
    this.node.addEventListener("pointerup", () => this.#up());
    this.node.addEventListener("pointercancel", () => this.#letGo());
    this.node.addEventListener("keydown", (event) => this.#key(event));
    this.node.addEventListener("keyup", () => this.#settle());
    this.node.addEventListener("blur", () => this.#settle());
  }

  draw(value: number, options: SpinOptions): void {
    this.#drawn = this.#value = value;
    this.#options = options;
    const text = options.text(value);
    write(this.#text, text);
    write(this.#after, options.after ?? "");
    show(this.#after, options.after !== undefined);
    put(this.node, {
      "aria-label": options.label, "aria-valuenow": value, "aria-valuetext": text,
      "aria-valuemin": told(options.min), "aria-valuemax": told(options.max), title: options.label,
    });
  }

  get #few(): boolean {
    const { min, max, step } = this.#options!;
    return (max - min) / step < FEW;
  }

  #set(value: number, moving: boolean): void {
    const { min, max, step, wraps, change } = this.#options!;
    let next = Number((Math.round(value / step) * step).toPrecision(12));
    if (wraps === true) next = ((((next - min) % (max - min)) + (max - min)) % (max - min)) + min;
    next = Math.max(min, Math.min(max, next));
    if (next === this.#value) return;
    this.#value = next;
    change(next, moving);
    requestAnimationFrame(() => (this.#value = this.#drawn)); // what was not taken is forgotten
  }

  #down(event: PointerEvent): void {
    if (event.button !== 0 || this.#typing !== null) return;
    this.#from = { x: event.clientX, value: this.#value, moved: false };
    this.node.setPointerCapture(event.pointerId);
  }

  #move(event: PointerEvent): void {
    const from = this.#from;
    if (from === null) return;
    const pixels = event.clientX - from.x;
    if (!from.moved && Math.abs(pixels) < PIXELS / 2) return;
    from.moved = true;
    this.#set(from.value + Math.round(pixels / PIXELS) * this.#options!.step, true);
  }

  #letGo(): void {
    if (this.#from?.moved === true) this.#options!.settle();
    this.#from = null;
  }

  #up(): void {
    const from = this.#from;
    this.#letGo();
    if (from === null || from.moved) return;
    if (this.#few) this.#next();
    else this.#type(null);
  }

  /** Few values step on a click, round and round. */
  #next(): void {
    const { min, max, step } = this.#options!;
    this.#set(this.#value + step > max ? min : this.#value + step, false);
  }

  #key(event: KeyboardEvent): void {
    if (this.#typing !== null || event.ctrlKey || event.metaKey || event.altKey) return;
    const { min, max, step } = this.#options!;
    const by = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: BIG, PageDown: -BIG }[event.key];
    if (by !== undefined) this.#set(this.#value + by * (event.shiftKey ? BIG : 1) * step, true);
    else if (event.key === "Home") this.#set(min, true);
    else if (event.key === "End" && Number.isFinite(max)) this.#set(max, true);
    else if (event.key === "Enter" || event.key === " ") {
      if (this.#few) this.#next();
      else this.#type(null);
    } else if (/^[\d.,−-]$/.test(event.key)) this.#type(event.key);
    else return;
    this.#stepped = by !== undefined || event.key === "Home" || event.key === "End";
    event.preventDefault();
    event.stopPropagation();
  }

  #settle(): void {
    if (this.#stepped) this.#options?.settle();
    this.#stepped = false;
  }

  #type(first: string | null): void {
    const shown = Number(this.#value.toPrecision(6));
    const input = el("input", { class: "spin-input", inputmode: "decimal", "aria-label": this.#options!.label, size: 5 });
    input.value = first ?? String(shown);
    this.#typing = input;
    this.node.classList.add("typing");
    this.node.append(input);
    input.focus();
    if (first === null) input.select();
    const done = (keep: boolean): void => {
      if (this.#typing === null) return;
      this.#typing = null;
      const value = Number(input.value.trim().replace(",", ".").replace("−", "-"));
      this.node.classList.remove("typing");
      const focused = input.matches(":focus");
      input.remove();
      if (focused) this.node.focus();
      if (keep && input.value.trim() !== "" && Number.isFinite(value)) this.#typed(value);
    };
    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Enter") done(true);
      else if (event.key === "Escape") done(false);
      else return;
      event.preventDefault();
    });
    input.addEventListener("blur", () => done(true));
  }

  /** A typed number is taken as it is, not rounded to steps. */
  #typed(value: number): void {
    const { min, max, wraps, change } = this.#options!;
    const within = wraps === true ? ((((value - min) % (max - min)) + (max - min)) % (max - min)) + min : value;
    change(Math.max(min, Math.min(max, within)), false);
  }
}

/** A bound that is worth telling. */
function told(bound: number): number | null {
  return Number.isFinite(bound) && bound !== Number.MIN_VALUE ? bound : null;
}

/** A word that is on, solid, or off, dashed. */
export class Word {
  readonly node = el("button", { type: "button", class: "control word" });
  #run: () => void = () => undefined;

  constructor() {
    this.node.addEventListener("click", () => this.#run());
  }

  draw(text: string, on: boolean, label: string, run: () => void): void {
    this.#run = run;
    write(this.node, text);
    put(this.node, { "aria-pressed": String(on), "aria-label": `${label}: ${text}`, title: label });
  }
}
