/* From the model's metres to the card's pixels, bow to the right or, on tall cards, up. */

import type { Pair } from "../messages";
import type { Shape } from "./shape";

/** A card narrower than this many of its heights has the bow up. */
const TALL = 1.15;

export class Screen {
  readonly turned: boolean;
  /** Pixels per metre. */
  readonly scale: number;
  readonly #centre: Pair;

  constructor(shape: Shape, readonly width: number, readonly height: number, lift = 0) {
    this.turned = width < TALL * height;
    const { left, right, bottom, top } = shape.box;
    const narrow = width < 520;
    const [side, above] = narrow ? [92, 84] : width < 760 ? [104, 92] : [124, 96];
    const wide = this.turned ? top - bottom : right - left;
    const high = this.turned ? right - left : top - bottom;
    this.scale = Math.max(1e-9, Math.min(
      (width - 2 * side) / wide, (height - 2 * above - lift) / high,
    ));
    const middle: Pair = [(left + right) / 2, (bottom + top) / 2];
    const [u, v] = this.#turn(middle);
    this.#centre = [width / 2 - this.scale * u, (height - lift) / 2 + this.scale * v];
  }

  /** Pixels of a point. */
  at(point: Pair): Pair {
    const [u, v] = this.#turn(point);
    return [this.#centre[0] + this.scale * u, this.#centre[1] - this.scale * v];
  }

  /** The point at a pixel. */
  model([x, y]: Pair): Pair {
    const u = (x - this.#centre[0]) / this.scale;
    const v = (this.#centre[1] - y) / this.scale;
    return this.turned ? [v, -u] : [u, v];
  }

  /** A direction [rad] as the card's own, counter-clockwise from its right. */
  angle(direction: number): number {
    return this.turned ? direction + Math.PI / 2 : direction;
  }

  /** The model's direction of a way on the card, given as pixels right and up. */
  direction(right: number, up: number): number {
    const angle = Math.atan2(up, right);
    return this.turned ? angle - Math.PI / 2 : angle;
  }

  /** Pixels away from a pixel in a direction of the model. */
  step([x, y]: Pair, direction: number, pixels: number): Pair {
    const angle = this.angle(direction);
    return [x + pixels * Math.cos(angle), y - pixels * Math.sin(angle)];
  }

  #turn([x, y]: Pair): Pair {
    return this.turned ? [-y, x] : [x, y];
  }
}

/** Numbers of a path, short. */
export function px(value: number): string {
  return String(Math.round(value * 100) / 100);
}

export function path(points: readonly Pair[], closed = false): string {
  return points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${px(x)} ${px(y)}`).join("") + (closed ? "Z" : "");
}
