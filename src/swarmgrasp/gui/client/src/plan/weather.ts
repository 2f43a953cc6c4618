/* Wind, current and waves, upper left: where they come from, in arrows and in words. */

import { el, put, show, svg, write } from "../dom";
import type { Pair, WavesData } from "../messages";
import type { BlowData, Speech } from "../speech";
import { arrow } from "./figures";
import type { Stage } from "./stage";

const SIZE = 56;
const MIDDLE: Pair = [SIZE / 2, SIZE / 2];

export class Weather {
  readonly node: HTMLElement;
  readonly #wind = svg("g", { class: "wind" });
  readonly #current = svg("g", { class: "current" });
  readonly #waves = svg("g", { class: "waves" });
  readonly #lines = [el("div", { class: "weather-first" }), el("div"), el("div"), el("div")];

  constructor() {
    const dial = svg("svg", { class: "compass", viewBox: `0 0 ${SIZE} ${SIZE}`, width: SIZE, height: SIZE, "aria-hidden": "true" },
      svg("circle", { class: "dial", cx: MIDDLE[0], cy: MIDDLE[1], r: SIZE / 2 - 1 }),
      this.#waves, this.#current, this.#wind);
    this.node = el("div", { class: "weather" }, dial, el("div", { class: "weather-words" }, ...this.#lines));
  }

  draw({ seen, screen, speech }: Stage): void {
    const { environment, in_weather } = seen.doc;
    const blows = in_weather && environment !== null;
    show(this.node, blows);
    if (!blows) return;
    const { wind, current, waves } = environment;
    const from = (blow: Pick<BlowData, "bearing"> | null): number | null => (blow === null ? null : blow.bearing ?? wind.bearing);
    const drawn = (group: SVGGElement, blow: BlowData | WavesData | null, radius: number, width: number): void => {
      const bearing = from(blow);
      put(group, { hidden: bearing === null || !(blow !== null && (!("speed" in blow) || (blow.speed ?? 0) > 0)) });
      if (bearing === null) return;
      const way = Math.PI - bearing;
      const [start, end] = [screen.step(MIDDLE, way, -radius), screen.step(MIDDLE, way, radius)];
      const { shaft, head } = arrow(start, end, width);
      group.replaceChildren(svg("path", { class: "shaft", d: shaft }), svg("path", { class: "head", d: head }));
    };
    drawn(this.#wind, wind, 19, 2.4);
    drawn(this.#current, current, 18, 1.6);
    drawn(this.#waves, waves, 14, 1.2);
    this.#write(wind, current, waves, speech);
  }

  #write(wind: BlowData, current: BlowData | null, waves: Pick<BlowData, "bearing"> | null, speech: Speech): void {
    const words = [
      wind.speed === null ? "no wind" : `wind ${speech.speed(wind.speed)}`,
      wind.bearing === null ? "" : `from ${speech.bearing(wind.bearing)}`,
      current === null || !current.speed ? "" : `current ${speech.speed(current.speed)}`
        + (current.bearing === null ? " with the wind" : ` from ${speech.bearing(current.bearing)}`),
      waves === null ? "" : "with waves" + (waves.bearing === null ? "" : ` from ${speech.bearing(waves.bearing)}`),
    ];
    this.#lines.forEach((line, i) => write(line, words[i]!));
  }
}
