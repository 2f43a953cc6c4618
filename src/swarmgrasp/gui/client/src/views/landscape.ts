/* How good every allowed place and direction is: a column for each, degrees off square up. */

import type { Context, Hovered, Seen, View } from "../context";
import { el, put, show, write } from "../dom";
import type { Tile } from "../layout";
import type { AnswerPart, LandscapePart, RobotData } from "../messages";
import { offSquare, Shape } from "../plan/shape";
import { stanceOf } from "../plan/stance";
import { signed, type Speech } from "../speech";
import { ALONE, axisOf, columnsOf, isFree, namesOf, offOf, pixelsOf, sectorOn, valueAt, type Axis, type Column } from "./columns";
import { palette, ramp, rgb, sheet, whenLooksChange, type Palette, type Rgb, type Sheet } from "./paint";

const DEGREE = Math.PI / 180;
const [LEFT, TOP, BELOW] = [34, 12, 26];
const FONT = "11.5px Inter, system-ui, sans-serif";

/** Of the inputs of a drawing, the answer. */
const ANSWER = 1;
/** Before the unit of a figure. */
const UNIT = /\u00a0(?=[^\d]+$)/;

interface Drawn {
  readonly part: LandscapePart;
  /** The answer that the part came with: it tells what its colours mean. */
  readonly answer: AnswerPart;
  /** The newcomer as it stands now. */
  readonly newcomer: RobotData | null;
  readonly shape: Shape;
  readonly axis: Axis;
  readonly columns: readonly Column[];
}

/** A place in the picture: a column, how far along it (0 to 1), and how far off square [rad]. */
interface Cursor {
  readonly column: number;
  readonly along: number;
  readonly off: number;
}

export class Landscape implements View {
  readonly #tile: Tile;
  readonly #context: Context;
  readonly #canvas = el("canvas", { class: "landscape", tabindex: 0, role: "application", "aria-roledescription": "map of places" });
  readonly #why = el("p", { class: "why" });
  readonly #low = el("span");
  readonly #high = el("span");
  readonly #picture = document.createElement("canvas");
  #drawn: Drawn | null = null;
  #inputs: readonly unknown[] = [];
  #seen: Seen | null = null;
  /** Whether the colours of `#picture` are those of what is drawn. */
  #coloured = "";
  #cursor: Cursor | null = null;

  constructor(tile: Tile, context: Context) {
    this.#tile = tile;
    this.#context = context;
    tile.body.append(this.#canvas, this.#why);
    tile.aside.append(this.#low, el("span", { class: "ramp", role: "img", "aria-label": "to" }), this.#high);
    tile.aside.classList.add("scale");
    this.#takeInHand();
    whenLooksChange(context.root, this.#canvas, () => {
      this.#inputs = [];
      if (this.#seen !== null) this.draw(this.#seen);
    });
    context.hover.listen(() => this.#paint());
  }

  draw(seen: Seen): void {
    this.#seen = seen;
    const { landscape, answer } = seen.parts;
    const inputs = [landscape, answer, seen.empty.landscape, seen.doc.problem.swarm.outline, this.#context.speech.value];
    if (inputs.every((input, i) => input === this.#inputs[i])) return;
    const before = this.#inputs;
    this.#inputs = inputs;
    const none = landscape === undefined || answer === undefined;
    write(this.#why, none ? seen.empty.landscape ?? "" : "");
    show(this.#canvas, !none);
    show(this.#tile.aside, !none);
    if (none) {
      this.#drawn = null;
      return;
    }
    // The same values with another answer: in a gesture they come later, or not at all.
    if (this.#drawn !== null && inputs.every((input, i) => input === before[i] || i === ANSWER)) {
      this.#drawn = { ...this.#drawn, newcomer: answer.newcomer };
      this.#paint();
      return;
    }
    const shape = new Shape(seen.doc.problem.swarm.outline);
    const width = this.#canvas.clientWidth - LEFT;
    const { problem } = seen.doc;
    const columns = columnsOf(landscape.pieces, shape, LEFT, Math.max(40, width), (piece) => sectorOn(problem, piece));
    this.#drawn = { part: landscape, answer, newcomer: answer.newcomer, shape, axis: axisOf(columns), columns };
    this.#coloured = "";
    this.#tell(this.#drawn);
    this.#paint();
  }

  #tell({ answer, part }: Drawn): void {
    const speech = this.#context.speech.value;
    const [low, high] = endsOf(answer, part);
    const [least, unit] = said(answer, low, speech).split(UNIT);
    const most = said(answer, high, speech);
    write(this.#low, unit === most.split(UNIT)[1] ? least! : said(answer, low, speech));
    write(this.#high, most);
    this.#label("");
  }

  #label(where: string): void {
    const { order } = this.#seen?.parts.answer ?? {};
    const best = order == null ? "" : ` Best at ${order.place}.`;
    put(this.#canvas, {
      "aria-label": where || `Places and directions.${best} Arrow keys look at a place, Escape leaves it.`,
    });
  }

  // -- drawing -------------------------------------------------------------------------------

  #paint(): void {
    const drawn = this.#drawn;
    if (drawn === null) return;
    const page = sheet(this.#canvas);
    if (page === null) return;
    const colours = palette(this.#canvas);
    this.#colour(drawn, page, colours);
    const { pen, width, height } = page;
    pen.imageSmoothingEnabled = true;
    pen.drawImage(this.#picture, LEFT, TOP, width - LEFT, height - TOP - BELOW);
    this.#drawAxis(page, drawn.axis, colours);
    const best = this.#best(drawn);
    this.#drawNames(page, drawn.columns, best?.column ?? -1, colours);
    if (best !== null) this.#mark(page, drawn, best, colours, 6);
    const at = this.#marked(drawn);
    if (at !== null) this.#mark(page, drawn, at, colours, 4.5);
  }

  /** The values as pixels, once for each drawing of theirs. */
  #colour(drawn: Drawn, page: Sheet, colours: Palette): void {
    const [width, height] = [Math.round(page.width - LEFT), Math.round(page.height - TOP - BELOW)];
    const key = `${width} ${height} ${colours.low}`;
    if (key === this.#coloured || width <= 0 || height <= 0) return;
    this.#coloured = key;
    this.#picture.width = width;
    this.#picture.height = height;
    const pen = this.#picture.getContext("2d")!;
    const image = pen.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    const table = Uint32Array.from(rampTable(colours), packed);
    const wash = packed(rgb(colours.wash));
    const [low, high] = endsOf(drawn.answer, drawn.part);
    const { unit } = drawn.part;
    const scale = 255 / Math.max(high - low, 1e-300);
    for (const column of drawn.columns) {
      const from = Math.round(column.left - LEFT);
      const wide = Math.max(0, Math.min(width, Math.round(column.left - LEFT + column.width)) - from);
      const values = pixelsOf(column, drawn.part.values, wide, height, drawn.axis.range);
      let i = 0;
      for (let y = 0; y < height; y++) {
        for (let at = y * width + from; at < y * width + from + wide; at++) {
          const value = values[i++]!;
          const shade = Math.max(0, Math.min(255, Math.round((value * unit - low) * scale)));
          pixels[at] = value < 0 ? wash : table[shade]!;
        }
      }
    }
    pen.putImageData(image, 0, 0);
  }

  #drawAxis({ pen, width, height }: Sheet, axis: Axis, colours: Palette): void {
    pen.font = `400 ${FONT}`;
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    pen.fillStyle = colours.grey;
    for (const tick of axis.ticks) {
      const y = yOf(tick, axis, height);
      pen.fillText(`${signed(Math.round(tick / DEGREE))}°`, LEFT - 6, y);
    }
    pen.fillStyle = colours.zone;
    pen.globalAlpha = 0.6;
    pen.fillRect(LEFT, Math.round(yOf(0, axis, height)), width - LEFT, 1);
    pen.globalAlpha = 1;
  }

  #drawNames({ pen, width, height }: Sheet, columns: readonly Column[], best: number, colours: Palette): void {
    const hovered = this.#context.hover.value;
    const zone = hovered?.kind === "zone" ? columns.findIndex(({ piece }) => piece.name === hovered.name) : -1;
    const first = zone >= 0 ? zone : best;
    pen.font = `600 ${FONT}`;
    pen.textAlign = "center";
    pen.textBaseline = "alphabetic";
    const names = namesOf(columns, first, (text) => pen.measureText(text).width, LEFT - 12, width);
    for (const { text, x, column } of names) {
      pen.font = `${column === best || column === zone ? 600 : 400} ${FONT}`;
      pen.fillStyle = column === best ? colours["new-text"] : column === zone ? colours.ink : colours.grey;
      pen.fillText(text, x, height - 9);
    }
    if (zone < 0) return;
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1;
    columns.forEach(({ piece, left, width: wide }) => {
      if (piece.name === columns[zone]!.piece.name) pen.strokeRect(left - 0.5, TOP - 0.5, wide + 1, height - TOP - BELOW + 1);
    });
  }

  #mark({ pen, height }: Sheet, { axis, columns }: Drawn, at: Cursor, colours: Palette, size: number): void {
    const column = columns[at.column]!;
    const [x, y] = [column.left + at.along * column.width, yOf(at.off, axis, height)];
    const inside = Math.max(column.left + size, Math.min(column.left + column.width - size, x));
    for (const [width, colour] of [[4.4, colours.card], [2, colours.ink]] as const) {
      pen.beginPath();
      pen.arc(inside, y, size, 0, 2 * Math.PI);
      pen.lineWidth = width;
      pen.strokeStyle = colour;
      pen.stroke();
    }
  }

  // -- places --------------------------------------------------------------------------------

  /** Where the newcomer stands now. */
  #best(drawn: Drawn): Cursor | null {
    return drawn.newcomer === null ? null : this.#cursorOf(drawn, drawn.newcomer);
  }

  #marked(drawn: Drawn): Cursor | null {
    const hovered = this.#context.hover.value;
    if (hovered?.kind === "place") return this.#cursor ?? this.#cursorOf(drawn, hovered.robot);
    return null;
  }

  #cursorOf({ shape, columns }: Drawn, robot: RobotData): Cursor | null {
    const { along } = stanceOf(shape, robot);
    const slack = 1e-6 * shape.perimeter;
    let found: Cursor | null = null;
    let nearest = Infinity;
    columns.forEach(({ piece, edge, off }, column) => {
      const far = beyond(along, piece.start, piece.end, shape.perimeter);
      const angle = isFree(piece) ? offOf(robot.direction - shape.inward(edge)) : offSquare(shape, edge, robot.direction);
      const outside = Math.max(0, off[0]! - angle, angle - off[off.length - 1]!);
      if (far > slack || far + outside >= nearest) return;
      nearest = far + outside;
      const length = piece.end - piece.start;
      const share = length > 0 ? Math.max(0, Math.min(1, shape.wrapped(along - piece.start + slack) / length)) : 0.5;
      found = { column, along: share, off: angle };
    });
    return found;
  }

  /** The newcomer as it would stand at a place of the picture. */
  #hoveredAt({ part, answer, shape, columns }: Drawn, at: Cursor): Extract<Hovered, { kind: "place" }> | null {
    const column = columns[at.column]!;
    const { piece, edge } = column;
    const value = valueAt(column, part.values, at.along, at.off);
    if (value === null || answer.newcomer === null) return null;
    const contact = shape.onEdge(edge, piece.start + at.along * (piece.end - piece.start) - shape.starts[edge]!);
    const off = piece.rows.length === 1 ? column.off[0]! : at.off;
    const flips = !isFree(piece) && Math.abs(piece.rows[Math.floor(piece.rows.length / 2)]!) > Math.PI / 2;
    const direction = shape.inward(edge) + off + (flips ? Math.PI : 0);
    return { kind: "place", robot: { ...answer.newcomer, contact, direction }, value: value * part.unit };
  }

  // -- hand and keys -------------------------------------------------------------------------

  #takeInHand(): void {
    const canvas = this.#canvas;
    canvas.addEventListener("pointermove", (event) => this.#look(this.#at(event)));
    canvas.addEventListener("pointerleave", () => this.#look(null));
    canvas.addEventListener("blur", () => this.#look(null));
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  #at(event: PointerEvent): Cursor | null {
    const drawn = this.#drawn;
    if (drawn === null) return null;
    const { offsetX: x, offsetY: y } = event;
    const column = drawn.columns.findIndex(({ left, width }) => x >= left && x <= left + width);
    if (column < 0) return null;
    const { left, width } = drawn.columns[column]!;
    const height = this.#canvas.clientHeight - TOP - BELOW;
    return { column, along: (x - left) / width, off: drawn.axis.range * (1 - (2 * (y - TOP)) / height) };
  }

  #look(cursor: Cursor | null): void {
    const drawn = this.#drawn;
    const { hover } = this.#context;
    const hovered = cursor === null || drawn === null ? null : this.#hoveredAt(drawn, cursor);
    this.#cursor = hovered === null ? null : cursor;
    if (hovered !== null) hover.set(hovered);
    else if (hover.value?.kind === "place") hover.set(null);
  }

  /** Arrows walk: across along the places, up and down in direction. */
  #key(event: KeyboardEvent): void {
    const drawn = this.#drawn;
    if (drawn === null || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === "Escape" && this.#cursor !== null) {
      event.stopPropagation();
      this.#look(null);
      this.#label("");
      return;
    }
    const across = { ArrowLeft: -1, ArrowRight: 1 }[event.key] ?? 0;
    const up = { ArrowDown: -1, ArrowUp: 1 }[event.key] ?? 0;
    if (across === 0 && up === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const from = this.#cursor ?? this.#best(drawn) ?? { column: 0, along: 0.5, off: 0 };
    const cursor = this.#cursor === null ? from : walked(drawn, from, across, up, event.shiftKey);
    this.#look(cursor);
    const hovered = this.#hoveredAt(drawn, cursor);
    if (hovered === null) return;
    const { piece, band } = drawn.columns[cursor.column]!;
    const speech = this.#context.speech.value;
    const way = band > ALONE ? `within ${speech.angle(band).replace("+", "")} of square` : `${speech.angle(cursor.off)} off square`;
    const sentence = `${piece.name || shapeName(drawn, cursor)}, ${way}: `
      + said(drawn.answer, hovered.value ?? 0, speech);
    this.#label(sentence);
    this.#context.say(sentence);
  }
}

function shapeName({ shape, columns }: Drawn, { column }: Cursor): string {
  return shape.nameOf(columns[column]!.edge);
}

/** One step: a cell along its piece or to the next, a degree or ten in direction. */
function walked({ columns }: Drawn, from: Cursor, across: number, up: number, far: boolean): Cursor {
  const cells = Math.max(1, columns[from.column]!.piece.columns.length - 1);
  let { column } = from;
  let along = from.along + (across * (far ? cells : 1)) / cells;
  if (across !== 0 && (along < -1e-9 || along > 1 + 1e-9 || columns[column]!.piece.columns.length === 1)) {
    const next = Math.max(0, Math.min(columns.length - 1, column + across));
    along = next === column ? Math.max(0, Math.min(1, along)) : across > 0 ? 0 : 1;
    column = next;
  }
  const { off: rows } = columns[column]!;
  const off = from.off + up * (far ? 10 : 1) * DEGREE;
  return { column, along, off: Math.max(rows[0]!, Math.min(rows[rows.length - 1]!, off)) };
}

/** How far an arc length is outside a stretch [m]. */
function beyond(along: number, start: number, end: number, perimeter: number): number {
  const around = (value: number): number => ((value % perimeter) + perimeter) % perimeter;
  if (around(along - start) <= end - start) return 0;
  return Math.min(around(start - along), around(along - end));
}

function yOf(off: number, axis: Axis, height: number): number {
  return TOP + ((1 - off / axis.range) / 2) * (height - TOP - BELOW);
}

/** The ends of the colours: what there is without the newcomer, and at its best. */
function endsOf(answer: AnswerPart, part: LandscapePart): readonly [number, number] {
  return answer.after > answer.before ? [answer.before, answer.after] : [part.low, part.high];
}

function said(answer: AnswerPart, value: number, speech: Speech): string {
  if (answer.question === "wind") return speech.speed(value);
  return answer.question === "load" ? `${value.toFixed(2)} times` : speech.force(value);
}

/** A colour as four bytes of a picture, on machines whose lowest byte comes first: all that browsers run on. */
function packed([red, green, blue]: Rgb): number {
  return (0xff000000 | (blue << 16) | (green << 8) | red) >>> 0;
}

function rampTable(colours: Palette): Rgb[] {
  const [low, middle, high] = [rgb(colours.low), rgb(colours.middle), rgb(colours.high)];
  return Array.from({ length: 256 }, (_, i) => ramp(low, middle, high, i / 255));
}
