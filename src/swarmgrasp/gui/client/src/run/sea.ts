/* A moment of a run, drawn on one canvas in the earth's frame. */

import type { Pair } from "../messages";
import { placed, type Placed, type Wanted } from "../plan/labels";
import { faint, palette, sheet, type Palette } from "../views/paint";
import type { Speech } from "../speech";
import { leadsIn, placedAt, type Film, type Moment, type Pose, type Standing } from "./film";

const TALL = 1.15;
/** Round the track: sideways, above, and for the timeline. */
const [SIDE, ABOVE, BAR] = [124, 84, 64];
const LOWEST = 20;
const FONT = "Inter, system-ui, sans-serif";
const NARROW = 520;
/** Points that a track is drawn through. */
const TRACK = 300;
/** Poses from which the room of a track is told. */
const SAMPLES = 200;

/** A track longer than so many times the object is not shown whole: the picture follows the object. */
const FOLLOWED = 3;

interface View {
  readonly scale: number;
  readonly turned: boolean;
  at(point: Pair): Pair;
}

interface Frame {
  readonly key: string;
  readonly turned: boolean;
  readonly scale: number;
  /** On the turned earth; null where the object is followed. */
  readonly middle: Pair | null;
  /** Pixels below the middle of the card: away from the weather where there is room. */
  readonly lower: number;
}

export class Sea {
  #turns: ReadonlyMap<string, number> = new Map();
  #frame: Frame | null = null;

  constructor(readonly canvas: HTMLCanvasElement, readonly film: Film) {}

  draw(moment: Moment, hovered: string | null, speech: Speech): void {
    const page = sheet(this.canvas);
    if (page === null) return;
    const view = this.#viewOf(page.width, page.height, moment.pose);
    const drawing = new Drawing(page.pen, view, this.film, palette(this.canvas), page.width < NARROW);
    drawing.paint(
      moment, hovered, (wanted, hull, arrows) => this.#labels(wanted, hull, arrows, page.width, page.height),
    );
    drawing.weather(moment, speech);
  }

  #labels(wanted: Wanted[], hull: readonly Pair[], arrows: readonly (readonly [Pair, Pair])[], width: number, height: number): Placed[] {
    const xs = hull.map(([x]) => x);
    const ys = hull.map(([, y]) => y);
    const box = { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
    const kept = [
      { left: 12, top: 12, right: width < NARROW ? 76 : 236, bottom: 76 },
      { left: 12, top: height - BAR - 4, right: width - 12, bottom: height },
    ];
    // A hull that lies askew fills little of its box; what it covers is dear only in the middle.
    const inner = { left: box.left * 0.7 + box.right * 0.3, right: box.left * 0.3 + box.right * 0.7, top: box.top * 0.7 + box.bottom * 0.3, bottom: box.top * 0.3 + box.bottom * 0.7 };
    const found = placed(wanted, { width, height, kept, hull: inner, sides: [], arrows }, this.#turns);
    this.#turns = new Map(found.map(({ key, turn }) => [key, turn]));
    return found;
  }

  #viewOf(width: number, height: number, pose: Pose): View {
    const { scale, turned, middle, lower } = this.#frameOf(width, height);
    const turn = ([x, y]: Pair): Pair => (turned ? [-y, x] : [x, y]);
    const [cx, cy] = middle ?? turn([pose[0], pose[1]]);
    return {
      scale, turned,
      at: (point) => {
        const [u, v] = turn(point);
        return [width / 2 + scale * (u - cx), (height - BAR) / 2 + lower - scale * (v - cy)];
      },
    };
  }

  /** The whole track in view, and its place; the bow up where the card is tall. */
  #frameOf(width: number, height: number): Frame {
    const key = `${width} ${height}`;
    if (this.#frame?.key === key) return this.#frame;
    const { poses, references, outline } = this.film.data;
    const turned = width < TALL * height;
    const xs: number[] = [];
    const ys: number[] = [];
    for (const points of [poses, references]) {
      const step = 3 * Math.max(1, Math.floor(points.length / 3 / SAMPLES));
      for (let i = 0; i < points.length; i += step) {
        for (const corner of outline) {
          const [x, y] = placedAt(corner, [points[i]!, points[i + 1]!, points[i + 2]!]);
          xs.push(turned ? -y : x);
          ys.push(turned ? x : y);
        }
      }
    }
    const [left, right] = ends(xs);
    const [low, high] = ends(ys);
    const reach = Math.max(...outline.map(([x, y]) => Math.hypot(x, y)));
    const followed = Math.max(right - left, high - low) > 2 * reach * FOLLOWED;
    const [wide, tall] = followed ? [2.4 * reach, 2.4 * reach] : [right - left, high - low];
    const side = width < NARROW ? 40 : SIDE;
    const scale = Math.max(1e-9, Math.min((width - 2 * side) / wide, (height - BAR - 2 * ABOVE) / tall));
    const lower = Math.min(LOWEST, Math.max(0, (height - BAR - scale * tall) / 2 - ABOVE));
    this.#frame = { key, turned, scale, lower, middle: followed ? null : [(left + right) / 2, (low + high) / 2] };
    return this.#frame;
  }
}

function ends(values: readonly number[]): Pair {
  return [values.reduce((a, b) => Math.min(a, b), Infinity), values.reduce((a, b) => Math.max(a, b), -Infinity)];
}

type Labeller = (wanted: Wanted[], hull: readonly Pair[], arrows: readonly (readonly [Pair, Pair])[]) => Placed[];

class Drawing {
  constructor(
    readonly pen: CanvasRenderingContext2D, readonly view: View, readonly film: Film,
    readonly colours: Palette, readonly narrow: boolean,
  ) {}

  paint(moment: Moment, hovered: string | null, labels: Labeller): void {
    const { outline, within } = this.film.data;
    this.#track(moment);
    this.#circle(moment, within);
    this.#hull(outline.map((at) => this.view.at(placedAt(at, moment.reference))), true);
    const hull = outline.map((at) => this.view.at(placedAt(at, moment.pose)));
    this.#hull(hull, false);
    const wanted: Wanted[] = [];
    const arrows: (readonly [Pair, Pair])[] = [];
    const shown = moment.robots.filter(({ phase }) => phase !== "away");
    for (const standing of shown) {
      const [from, to] = this.#robot(standing, moment.pose, standing.actor.name === hovered);
      arrows.push([from, to]);
      this.pen.font = `600 13px ${FONT}`;
      const width = Math.max(this.pen.measureText(standing.actor.name).width, this.#below(standing).width);
      wanted.push({
        key: standing.actor.name, end: to, angle: Math.atan2(from[1] - to[1], to[0] - from[0]),
        width, height: 30, off: 9, optional: shown.length > 12, inside: false,
      });
    }
    for (const label of labels(wanted, hull, arrows)) {
      this.#label(label, shown.find(({ actor }) => actor.name === label.key)!);
    }
  }

  #path(points: readonly Pair[], closed: boolean): void {
    this.pen.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? this.pen.moveTo(x, y) : this.pen.lineTo(x, y)));
    if (closed) this.pen.closePath();
  }

  #track(moment: Moment): void {
    const { times, poses } = this.film.data;
    const step = Math.max(1, Math.floor(times.length / TRACK));
    const points: Pair[] = [];
    for (let i = 0; i < times.length && times[i]! <= moment.time; i += step) {
      points.push(this.view.at([poses[3 * i]!, poses[3 * i + 1]!]));
    }
    points.push(this.view.at([moment.pose[0], moment.pose[1]]));
    this.#path(points, false);
    this.pen.lineWidth = 1.2;
    this.pen.strokeStyle = faint(this.colours.grey, 0.6);
    this.pen.stroke();
  }

  #circle({ reference, off }: Moment, within: number): void {
    const [x, y] = this.view.at([reference[0], reference[1]]);
    this.pen.beginPath();
    this.pen.arc(x, y, Math.max(2, within * this.view.scale), 0, 2 * Math.PI);
    const colour = off <= within ? this.colours.good : this.colours.bad;
    this.pen.fillStyle = faint(colour, 0.07);
    this.pen.fill();
    this.pen.lineWidth = 1.4;
    this.pen.strokeStyle = colour;
    this.pen.stroke();
  }

  #hull(points: readonly Pair[], wanted: boolean): void {
    this.#path(points, true);
    if (wanted) this.pen.setLineDash([4, 4]);
    else {
      this.pen.fillStyle = faint(this.colours.hull, 0.86);
      this.pen.fill();
    }
    this.pen.lineWidth = wanted ? 1.1 : 1.5;
    this.pen.strokeStyle = wanted ? this.colours.grey : this.colours["hull-line"];
    this.pen.lineJoin = "round";
    this.pen.stroke();
    this.pen.setLineDash([]);
  }

  /** Draws one robot; its shaft as it lies on the card. */
  #robot(standing: Standing, pose: Pose, hovered: boolean): readonly [Pair, Pair] {
    const { actor, phase, way, share, done } = standing;
    const contact = this.view.at(placedAt(standing.at, pose));
    const isIn = leadsIn(this.film.data.outline, actor.contact, actor.direction);
    const heading = pose[2] + way + (isIn ? Math.PI : 0);
    const ahead = this.view.turned ? heading + Math.PI / 2 : heading;
    const length = this.#length(actor.limit);
    const out = (along: number): Pair => [contact[0] + along * Math.cos(ahead), contact[1] - along * Math.sin(ahead)];
    const colour = actor.newcomer ? this.colours.new : this.colours.robot;
    if (phase !== "coming") {
      this.#line(out(8), out(8 + length), 6, this.colours.line);
      if (phase === "holds" && share > 0.004) this.#line(out(8), out(8 + length * Math.min(1, share)), 6, colour);
    }
    if (phase === "coming") this.#way(standing, pose);
    const pen = this.pen;
    pen.beginPath();
    pen.arc(contact[0], contact[1], 5, 0, 2 * Math.PI);
    pen.fillStyle = this.colours.card;
    pen.fill();
    pen.lineWidth = 2;
    pen.strokeStyle = phase === "lost" ? this.colours.bad : colour;
    if (phase === "coming") pen.setLineDash([3, 3]);
    pen.stroke();
    pen.setLineDash([]);
    if (phase === "lost") this.#cross(contact);
    if (phase === "making fast") this.#ring(contact, done, colour);
    if (hovered) this.#ring(contact, 1, faint(colour, 0.5));
    return [contact, phase === "coming" ? out(1) : out(8 + length)];
  }

  #length(limit: number): number {
    const most = Math.max(...this.film.data.robots.map((robot) => robot.limit));
    return Math.max(18, ((this.narrow ? 36 : 48) * limit) / most);
  }

  #line(from: Pair, to: Pair, width: number, colour: string): void {
    this.#path([from, to], false);
    this.pen.lineCap = "round";
    this.pen.lineWidth = width;
    this.pen.strokeStyle = colour;
    this.pen.stroke();
    this.pen.lineCap = "butt";
  }

  #way({ actor }: Standing, pose: Pose): void {
    const route = this.film.data.routes.find(({ robot }) => robot === actor.name);
    if (route === undefined) return;
    this.#path(route.points.map((at) => this.view.at(placedAt(at, pose))), false);
    this.pen.setLineDash([1, 5]);
    this.pen.lineCap = "round";
    this.pen.lineWidth = 2;
    this.pen.strokeStyle = faint(this.colours["new-text"], 0.6);
    this.pen.stroke();
    this.pen.lineCap = "butt";
    this.pen.setLineDash([]);
  }

  #ring([x, y]: Pair, share: number, colour: string): void {
    this.pen.beginPath();
    this.pen.arc(x, y, 11, -Math.PI / 2, -Math.PI / 2 + 2 * Math.PI * share);
    this.pen.lineWidth = 3.5;
    this.pen.strokeStyle = colour;
    this.pen.stroke();
  }

  #cross([x, y]: Pair): void {
    this.pen.beginPath();
    for (const [dx, dy] of [[5, 5], [5, -5]] as const) {
      this.pen.moveTo(x - dx, y - dy);
      this.pen.lineTo(x + dx, y + dy);
    }
    this.pen.lineWidth = 2;
    this.pen.strokeStyle = this.colours.bad;
    this.pen.stroke();
  }

  #below(standing: Standing): { text: string; width: number } {
    const text = saidOf(standing);
    this.pen.font = `400 12px ${FONT}`;
    return { text, width: this.pen.measureText(text).width };
  }

  /** Where wind and current lead on the card, and how fast they are. */
  weather({ wind, water }: Moment, speech: Speech): void {
    const pen = this.pen;
    const [x, y] = this.narrow ? [40, 40] : [48, 44];
    pen.beginPath();
    pen.arc(x, y, 26, 0, 2 * Math.PI);
    pen.lineWidth = 1;
    pen.strokeStyle = this.colours.line;
    pen.stroke();
    const [blows, flows] = [Math.hypot(...wind), Math.hypot(...water)];
    if (flows > 0) this.#vane([x, y], water, 1.6, this.colours.grey, [3, 3]);
    if (blows > 0) this.#vane([x, y], wind, 2.4, this.colours.ink, []);
    if (this.narrow) return;
    pen.textAlign = "left";
    pen.font = `600 13px ${FONT}`;
    pen.fillStyle = this.colours.ink;
    pen.fillText(`wind ${speech.speed(blows)}`, x + 38, y - 1);
    if (flows === 0) return;
    pen.font = `400 12px ${FONT}`;
    pen.fillStyle = this.colours.grey;
    pen.fillText(`current ${speech.speed(flows)}`, x + 38, y + 16);
  }

  #vane([x, y]: Pair, [u, v]: Pair, width: number, colour: string, dash: number[]): void {
    const angle = Math.atan2(v, u) + (this.view.turned ? Math.PI / 2 : 0);
    const [cos, sin] = [Math.cos(angle), -Math.sin(angle)];
    const pen = this.pen;
    this.#path([[x - 18 * cos, y - 18 * sin], [x + 12 * cos, y + 12 * sin]], false);
    pen.setLineDash(dash);
    pen.lineWidth = width;
    pen.strokeStyle = pen.fillStyle = colour;
    pen.stroke();
    pen.setLineDash([]);
    this.#path([
      [x + 20 * cos, y + 20 * sin], [x + 10 * cos - 5 * sin, y + 10 * sin + 5 * cos],
      [x + 10 * cos + 5 * sin, y + 10 * sin - 5 * cos],
    ], true);
    pen.fill();
  }

  #label({ at: [x, top], anchor }: Placed, standing: Standing): void {
    const pen = this.pen;
    const { phase, actor } = standing;
    pen.textAlign = anchor === "middle" ? "center" : anchor;
    pen.textBaseline = "alphabetic";
    pen.font = `600 13px ${FONT}`;
    pen.fillStyle = phase === "lost" ? this.colours.bad : actor.newcomer ? this.colours["new-text"] : this.colours.robot;
    pen.fillText(actor.name, x, top + 11);
    pen.font = `400 12px ${FONT}`;
    pen.fillStyle = this.colours.grey;
    pen.fillText(saidOf(standing), x, top + 26);
  }
}

/** What a robot does, in a word or a share. */
export function saidOf({ phase, share }: Standing): string {
  if (phase === "holds") return `${Math.round(100 * share)}\u00a0%`;
  return phase === "lost" ? "failed" : phase === "away" ? "not there" : phase;
}
