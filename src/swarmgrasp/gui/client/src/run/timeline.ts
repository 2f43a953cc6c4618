/* The bar of time: play, scrub, speed, and where something happened. */

import type { Context } from "../context";
import { el, put, svg, write } from "../dom";
import { clock, type Film } from "./film";

const SPEEDS = [1, 2, 5, 10, 30, 60];
const SMALL = 5;
const LARGE = 30;

export interface Hand {
  readonly time: () => number;
  readonly seek: (time: number) => void;
  readonly close: () => void;
}

export class Timeline {
  readonly #film: Film;
  readonly #hand: Hand;
  readonly #play = el("button", { type: "button", class: "play" });
  readonly #now = el("span", { class: "now" });
  readonly #speed = el("button", { type: "button", class: "control speed" });
  readonly #track = el("div", { class: "track", role: "slider", tabindex: 0, "aria-label": "Time" });
  readonly #gone = el("div", { class: "gone" });
  readonly #thumb = el("div", { class: "thumb" });
  #playing = false;
  #rate = 10;
  #last = 0;

  constructor(room: HTMLElement, film: Film, context: Context, hand: Hand) {
    this.#film = film;
    this.#hand = hand;
    const close = el("button", { type: "button", class: "icon-button", "aria-label": "Leave the run", title: "Leave the run" }, cross());
    close.addEventListener("click", hand.close);
    this.#track.append(curveOf(film), el("div", { class: "rail" }), this.#gone, ...marksOf(film), this.#thumb);
    room.replaceChildren(this.#play, this.#now, this.#track, el("span", { class: "end" }, clock(film.duration)), this.#speed, close);
    this.#play.addEventListener("click", () => this.toggle());
    this.#speed.addEventListener("click", () => this.faster(1, true));
    this.#takeInHand();
    this.#draw();
    if (!context.calm()) this.toggle();
  }

  get playing(): boolean {
    return this.#playing;
  }

  toggle(): void {
    if (!this.#playing && this.#hand.time() >= this.#film.duration) this.#hand.seek(0);
    this.#playing = !this.#playing;
    this.#last = performance.now();
    this.#draw();
    if (this.#playing) requestAnimationFrame((now) => this.#step(now));
  }

  pause(): void {
    if (this.#playing) this.toggle();
  }

  /** The next speed up or down; with `round` from the last to the first. */
  faster(by: number, round = false): void {
    const at = SPEEDS.indexOf(this.#rate) + by;
    this.#rate = SPEEDS[round ? (at + SPEEDS.length) % SPEEDS.length : Math.max(0, Math.min(SPEEDS.length - 1, at))]!;
    this.#draw();
  }

  /** Where time is, on the bar. */
  moved(words: string): void {
    const time = this.#hand.time();
    const share = `${this.#film.duration > 0 ? (100 * time) / this.#film.duration : 0}%`;
    this.#gone.style.width = share;
    this.#thumb.style.left = share;
    write(this.#now, clock(time));
    put(this.#track, {
      "aria-valuemin": 0, "aria-valuemax": Math.round(this.#film.duration), "aria-valuenow": Math.round(time),
      "aria-valuetext": `${clock(time)} of ${clock(this.#film.duration)}: ${words}`,
    });
  }

  /** Returns whether the key meant time. */
  key(event: KeyboardEvent): boolean {
    const size = event.shiftKey ? LARGE : SMALL;
    const onBar = event.composedPath().includes(this.#track);
    if (event.key === " " && !(event.target instanceof HTMLButtonElement)) this.toggle();
    else if (event.key === "<") this.faster(-1);
    else if (event.key === ">") this.faster(1);
    else if (onBar && (event.key === "ArrowRight" || event.key === "ArrowUp")) this.#seek(this.#hand.time() + size);
    else if (onBar && (event.key === "ArrowLeft" || event.key === "ArrowDown")) this.#seek(this.#hand.time() - size);
    else if (onBar && event.key === "Home") this.#seek(0);
    else if (onBar && event.key === "End") this.#seek(this.#film.duration);
    else return false;
    return true;
  }

  #seek(time: number): void {
    this.#hand.seek(Math.max(0, Math.min(this.#film.duration, time)));
  }

  #takeInHand(): void {
    const track = this.#track;
    const follow = (event: PointerEvent): void => {
      const box = track.getBoundingClientRect();
      this.#seek(((event.clientX - box.left) / box.width) * this.#film.duration);
    };
    track.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      track.setPointerCapture(event.pointerId);
      follow(event);
    });
    track.addEventListener("pointermove", (event) => {
      if (track.hasPointerCapture(event.pointerId)) follow(event);
    });
  }

  #step(now: number): void {
    if (!this.#playing) return;
    const time = this.#hand.time() + ((now - this.#last) / 1000) * this.#rate;
    this.#last = now;
    this.#hand.seek(Math.min(this.#film.duration, time));
    if (time >= this.#film.duration) this.toggle();
    else requestAnimationFrame((next) => this.#step(next));
  }

  #draw(): void {
    put(this.#play, { "aria-label": this.#playing ? "Pause" : "Play", title: this.#playing ? "Pause" : "Play" });
    this.#play.replaceChildren(sign(this.#playing ? "M7 5h2v10H7zM11 5h2v10h-2z" : "M7.5 4.5v11l8-5.5z"));
    write(this.#speed, `${this.#rate}×`);
    put(this.#speed, { "aria-label": `Speed: ${this.#rate} times` });
  }
}

function sign(d: string): SVGSVGElement {
  return svg("svg", { viewBox: "0 0 20 20", width: 20, height: 20, "aria-hidden": "true" }, svg("path", { d, fill: "currentColor" }));
}

function cross(): SVGSVGElement {
  return svg("svg", { viewBox: "0 0 20 20", width: 20, height: 20, class: "icon", "aria-hidden": "true" },
    svg("path", { d: "m5 5 10 10" }), svg("path", { d: "M15 5 5 15" }));
}

/** How far off its place, as a pale curve: the eye goes where something happened. */
function curveOf(film: Film): SVGSVGElement {
  const many = Math.min(400, film.offs.length);
  const most = Math.max(film.furthest, 1e-9);
  let d = "M0 20";
  for (let i = 0; i < many; i++) {
    const from = Math.floor((i * film.offs.length) / many);
    const to = Math.max(from + 1, Math.floor(((i + 1) * film.offs.length) / many));
    const off = film.offs.subarray(from, to).reduce((max, value) => Math.max(max, value), 0);
    d += `L${((100 * i) / Math.max(1, many - 1)).toFixed(2)} ${(20 - (20 * off) / most).toFixed(2)}`;
  }
  return svg("svg", { class: "offs", viewBox: "0 0 100 20", preserveAspectRatio: "none", "aria-hidden": "true" },
    svg("path", { d: `${d}L100 20Z` }));
}

function marksOf(film: Film): HTMLElement[] {
  const worst = film.offs.indexOf(film.furthest);
  const marks = film.data.happenings.filter(({ time }) => time > 0).map(({ time, kind, words }) => {
    const mark = el("div", { class: "mark", "data-kind": kind, title: `${clock(time)} ${words}` });
    mark.style.left = `${(100 * time) / film.duration}%`;
    return mark;
  });
  if (film.furthest > film.data.within) {
    const mark = el("div", { class: "mark", "data-kind": "worst" });
    mark.style.left = `${(100 * film.data.times[worst]!) / film.duration}%`;
    marks.push(mark);
  }
  return marks;
}
