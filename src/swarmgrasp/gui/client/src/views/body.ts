/* The wrench set in the round: faces behind, the ball, faces in front. */

import type { Context, Seen, View } from "../context";
import { el, put, write } from "../dom";
import type { Tile } from "../layout";
import type { MeshPart, ProblemData, Triple } from "../messages";
import { faint, palette, sheet, whenLooksChange, type Palette, type Sheet } from "./paint";
import { axesOf, dot, FIRST_EYE, isAlong, rimOf, Solid, turned, type Axes, type Eye, type Point } from "./solid";

/** Above so many faces edges thin out; above so many there are none. */
const [MANY_FACES, MOST_EDGED] = [150, 800];
/** Light falls from above, the left and the front. */
const LIGHT: Triple = [-0.5, 0.62, 0.6];
/** The size stays until it is so far off, so that a drag does not make it breathe. */
const CALM = 0.25;
const KEY_STEP = 12;
const MARGIN = 10;
const SHADES = 48;

export class Body implements View {
  readonly #tile: Tile;
  readonly #context: Context;
  readonly #canvas = el("canvas", { class: "body", role: "img", tabindex: 0 });
  readonly #why = el("p", { class: "why" });
  #eye: Eye = FIRST_EYE;
  #solid: Solid | null = null;
  #mesh: MeshPart | undefined;
  #seen: Seen | null = null;
  #scale = 0;
  #drawn: readonly unknown[] = [];

  constructor(tile: Tile, context: Context) {
    this.#tile = tile;
    this.#context = context;
    tile.body.append(this.#canvas, this.#why);
    this.#takeInHand();
    const again = (): void => this.#paint();
    whenLooksChange(context.root, this.#canvas, again);
    context.hover.listen(again);
  }

  draw(seen: Seen): void {
    this.#seen = seen;
    const { mesh, answer } = seen.parts;
    const inputs = [mesh, answer, seen.empty.mesh, this.#context.speech.value];
    if (inputs.every((input, i) => input === this.#drawn[i])) return;
    this.#drawn = inputs;
    const isNew = mesh !== this.#mesh || this.#context.hover.value !== null;
    if (mesh !== this.#mesh) {
      this.#mesh = mesh;
      this.#solid = mesh === undefined ? null : new Solid(mesh, MOST_EDGED);
    }
    write(this.#why, mesh === undefined ? seen.empty.mesh ?? "" : "");
    put(this.#canvas, { hidden: mesh === undefined });
    this.#tell(mesh);
    if (isNew) this.#paint();
  }

  #tell(mesh: MeshPart | undefined): void {
    const speech = this.#context.speech.value;
    const held = mesh?.ball != null && mesh.ball.radius > 0;
    const told = mesh === undefined ? "" : held ? `ball ${speech.force(mesh.ball!.radius * mesh.unit)}` : "not held";
    write(this.#tile.aside, told);
    const weakest = this.#seen?.parts.answer?.facts.find((fact) => fact.mark === "weakest");
    put(this.#canvas, {
      "aria-label": `All wrenches that can be held, in the round: ${told}`
        + `${weakest === undefined ? "" : `; weakest ${weakest.text}`}. Arrow keys turn it, Home turns it back.`,
    });
  }

  #takeInHand(): void {
    const canvas = this.#canvas;
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button === 0) canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (canvas.hasPointerCapture(event.pointerId)) this.#turn(event.movementX, event.movementY);
    });
    canvas.addEventListener("dblclick", () => this.#look(FIRST_EYE));
    canvas.addEventListener("keydown", (event) => {
      if (event.altKey || event.ctrlKey || event.metaKey) return;
      const step = KEY_STEP * (event.shiftKey ? 3 : 1);
      if (event.key === "Home") this.#look(FIRST_EYE);
      else if (event.key === "ArrowLeft") this.#turn(-step, 0);
      else if (event.key === "ArrowRight") this.#turn(step, 0);
      else if (event.key === "ArrowUp") this.#turn(0, -step);
      else if (event.key === "ArrowDown") this.#turn(0, step);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  #turn(dx: number, dy: number): void {
    this.#look(turned(this.#eye, dx, dy));
  }

  #look(eye: Eye): void {
    this.#eye = eye;
    this.#paint();
  }

  #paint(): void {
    const [mesh, solid] = [this.#mesh, this.#solid];
    if (mesh === undefined || solid === null) return;
    const page = sheet(this.#canvas);
    if (page === null) return;
    const fits = (Math.min(page.width, page.height) / 2 - MARGIN) / (solid.radius * mesh.unit);
    const before = this.#scale;
    this.#scale = before > 0 && fits < before && before < fits * (1 + CALM) && this.#seen?.moving === true
      ? before : fits;
    new Painter(page, mesh, solid, axesOf(this.#eye), this.#scale * mesh.unit, palette(this.#canvas))
      .paint(this.#hovered(), this.#weakHovered());
  }

  /** The direction of the wrenches of the robot that is hovered, as the metric has them. */
  #hovered(): Triple | null {
    const hovered = this.#context.hover.value;
    if (hovered === null || hovered.kind === "zone" || this.#seen === null) return null;
    const { problem } = this.#seen.doc;
    const robot = hovered.kind === "place" ? hovered.robot
      : [...problem.swarm.robots, this.#seen.parts.answer?.newcomer].find((one) => one?.name === hovered.name);
    return robot == null ? null : wrenchOf(robot, problem);
  }

  #weakHovered(): boolean {
    const hovered = this.#context.hover.value;
    const names = this.#seen?.parts.answer?.weakest?.names ?? [];
    return hovered?.kind === "robot" && names.includes(hovered.name);
  }
}

/** The wrench of a push with a robot's limit, as the metric measures it. */
function wrenchOf(robot: { contact: [number, number]; direction: number; limit: number }, problem: ProblemData): Triple {
  const { outline, force_weights: weights, characteristic_length: length } = problem.swarm;
  const [x, y] = [robot.contact[0] - outline.origin[0], robot.contact[1] - outline.origin[1]];
  const [fx, fy] = [robot.limit * Math.cos(robot.direction), robot.limit * Math.sin(robot.direction)];
  return [fx * weights[0], fy * weights[1], (x * fy - y * fx) / length];
}

/** One drawing. */
class Painter {
  readonly #pen: CanvasRenderingContext2D;
  readonly #points: Point[] = [];

  constructor(
    readonly page: Sheet, readonly mesh: MeshPart, readonly solid: Solid, readonly axes: Axes,
    /** Pixels per step. */
    readonly scale: number, readonly colours: Palette,
  ) {
    this.#pen = page.pen;
    const { corners } = solid;
    for (let i = 0; i < corners.length; i += 3) {
      this.#points.push(this.#project([corners[i]!, corners[i + 1]!, corners[i + 2]!]));
    }
  }

  paint(hovered: Triple | null, weakHovered: boolean): void {
    const { ball } = this.mesh;
    const { solid, axes } = this;
    const limiting = this.#limiting();
    const limitsInFront = limiting !== null && solid.isFront(limiting, axes);
    const many = solid.faces.length > MOST_EDGED;
    if (!many) this.#edges(false);
    if (limiting !== null && !limitsInFront) this.#limit(limiting, weakHovered);
    if (ball !== null && ball.radius > 0) this.#ball(ball.centre, ball.radius);
    this.#faces();
    if (many) this.#outline();
    else this.#edges(true);
    if (hovered !== null && !many) this.#band(hovered);
    if (limiting !== null && limitsInFront) this.#limit(limiting, weakHovered);
    if (ball !== null && ball.radius > 0) this.#touch(ball.touches);
    else this.#needed();
    this.#tripod();
  }

  /** The face that the ball touches; none where it touches a round part. */
  #limiting(): number | null {
    const { ball } = this.mesh;
    if (ball === null || ball.face === null || ball.radius <= 0) return null;
    const way = ball.touches.map((part) => part / ball.radius) as Triple;
    return this.solid.facing(ball.face, way) > 0.995 ? ball.face : null;
  }

  #project(at: Triple): Point {
    const { right, up } = this.axes;
    const { middle } = this.solid;
    const from: Triple = [at[0] - middle[0], at[1] - middle[1], at[2] - middle[2]];
    return [
      this.page.width / 2 + this.scale * dot(right, from),
      this.page.height / 2 - this.scale * dot(up, from),
    ];
  }

  #trace(face: number): void {
    this.solid.faces[face]!.forEach((corner, i) => {
      const [x, y] = this.#points[corner]!;
      if (i === 0) this.#pen.moveTo(x, y);
      else this.#pen.lineTo(x, y);
    });
    this.#pen.closePath();
  }

  #faces(): void {
    const { solid, axes } = this;
    const light = lightOf(axes);
    const many = solid.faces.length > MOST_EDGED;
    const shades = Array.from({ length: SHADES + 1 }, (_, i) => faint(this.colours.robot, 0.07 + (0.17 * i) / SHADES));
    for (let face = 0; face < solid.faces.length; face++) {
      if (!solid.isFront(face, axes)) continue;
      this.#pen.beginPath();
      this.#trace(face);
      const dark = 1 - Math.max(0, solid.facing(face, light));
      this.#pen.fillStyle = shades[Math.round(SHADES * Math.min(1, dark))]!;
      this.#pen.fill();
      if (!many) continue;
      this.#pen.strokeStyle = faint(this.colours.robot, 0.13);
      this.#pen.lineWidth = 0.5;
      this.#pen.stroke();
    }
  }

  /** Edges in front, or only those behind. */
  #edges(front: boolean): void {
    const { solid, axes } = this;
    const dense = solid.faces.length > MANY_FACES;
    this.#pen.beginPath();
    for (const { from, to, faces, creased } of solid.edges) {
      if (dense && !creased) continue;
      if (faces.some((face) => solid.isFront(face, axes)) !== front) continue;
      this.#pen.moveTo(...this.#points[from]!);
      this.#pen.lineTo(...this.#points[to]!);
    }
    this.#pen.lineJoin = "round";
    this.#pen.lineWidth = front ? (dense ? 0.7 : 1) : 0.8;
    this.#pen.strokeStyle = faint(this.colours.robot, front ? (dense ? 0.34 : 0.8) : dense ? 0.1 : 0.3);
    this.#pen.stroke();
    if (front && dense) this.#outline();
  }

  #outline(): void {
    this.#pen.beginPath();
    rimOf(this.#points).forEach(([x, y], i) => (i === 0 ? this.#pen.moveTo(x, y) : this.#pen.lineTo(x, y)));
    this.#pen.closePath();
    this.#pen.lineWidth = 1.2;
    this.#pen.strokeStyle = this.colours.robot;
    this.#pen.stroke();
  }

  /** The edges that a robot draws: all that are parallel to its wrenches. */
  #band(wrench: Triple): void {
    const { solid } = this;
    this.#pen.beginPath();
    for (const { from, to } of solid.edges) {
      if (!isAlong(solid.corners, from, to, wrench)) continue;
      this.#pen.moveTo(...this.#points[from]!);
      this.#pen.lineTo(...this.#points[to]!);
    }
    this.#pen.lineWidth = 2.4;
    this.#pen.strokeStyle = this.colours.ink;
    this.#pen.stroke();
  }

  #ball(centre: Triple, radius: number): void {
    const [x, y] = this.#project(centre);
    const r = radius * this.scale;
    const { new: colour } = this.colours;
    const shade = this.#pen.createRadialGradient(x - 0.38 * r, y - 0.42 * r, 0.05 * r, x, y, r);
    shade.addColorStop(0, mixed(colour, "#ffffff", 0.72));
    shade.addColorStop(0.55, mixed(colour, "#ffffff", 0.12));
    shade.addColorStop(1, mixed(colour, "#000000", 0.24));
    this.#pen.globalAlpha = 0.92;
    this.#pen.beginPath();
    this.#pen.arc(x, y, r, 0, 2 * Math.PI);
    this.#pen.fillStyle = shade;
    this.#pen.fill();
    this.#pen.globalAlpha = 1;
    const before = (this.mesh.before ?? 0) * this.scale;
    if (before <= 0.5) return;
    this.#pen.beginPath();
    this.#pen.arc(x, y, before, 0, 2 * Math.PI);
    this.#pen.setLineDash([3, 3]);
    this.#pen.lineWidth = 1.2;
    this.#pen.strokeStyle = this.colours.grey;
    this.#pen.stroke();
    this.#pen.setLineDash([]);
  }

  #limit(face: number, hovered: boolean): void {
    this.#pen.beginPath();
    this.#trace(face);
    this.#pen.fillStyle = faint(this.colours.weak, hovered ? 0.4 : 0.22);
    this.#pen.fill();
    this.#pen.lineWidth = hovered ? 2.6 : 1.6;
    this.#pen.strokeStyle = this.colours.weak;
    this.#pen.stroke();
  }

  /** Where the ball touches; hollow on its far side. */
  #touch(at: Triple): void {
    const [x, y] = this.#project(at);
    const behind = dot(at, this.axes.near) < 0;
    this.#pen.beginPath();
    this.#pen.arc(x, y, 3.4, 0, 2 * Math.PI);
    this.#pen.fillStyle = behind ? this.colours.card : this.colours.weak;
    this.#pen.fill();
    this.#pen.lineWidth = 1.4;
    this.#pen.strokeStyle = behind ? this.colours.weak : this.colours.card;
    this.#pen.stroke();
  }

  /** What must be held, where it is not. */
  #needed(): void {
    const [x, y] = this.#project(this.mesh.needed);
    const pen = this.#pen;
    pen.beginPath();
    pen.arc(x, y, 5, 0, 2 * Math.PI);
    pen.lineWidth = 2;
    pen.strokeStyle = this.colours.bad;
    pen.stroke();
    pen.font = "400 12px Inter, system-ui, sans-serif";
    pen.textBaseline = "middle";
    pen.lineWidth = 4;
    pen.lineJoin = "round";
    pen.strokeStyle = this.colours.card;
    const right = x + 10 + pen.measureText("needed").width < this.page.width;
    pen.textAlign = right ? "left" : "right";
    pen.strokeText("needed", x + (right ? 10 : -10), y);
    pen.fillStyle = this.colours.bad;
    pen.fillText("needed", x + (right ? 10 : -10), y);
  }

  #tripod(): void {
    const pen = this.#pen;
    const [x, y] = [20, this.page.height - 22];
    const { right, up } = this.axes;
    pen.font = "400 11.5px Inter, system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillStyle = pen.strokeStyle = this.colours.grey;
    pen.lineWidth = 1;
    ["ahead", "port", "turn"].forEach((word, k) => {
      const [dx, dy] = [12 * right[k as 0]!, -12 * up[k as 0]!];
      pen.beginPath();
      pen.moveTo(x, y);
      pen.lineTo(x + dx, y + dy);
      pen.stroke();
      const size = Math.hypot(dx, dy);
      if (size < 3) return;
      const reach = size + 6;
      const half = pen.measureText(word).width / 2;
      pen.fillText(word, Math.max(half, x + (dx / size) * (reach + half * Math.abs(dx / size))), y + (dy / size) * (reach + 4));
    });
  }
}

function lightOf({ right, up, near }: Axes): Triple {
  const [x, y, z] = LIGHT;
  const size = Math.hypot(...LIGHT);
  return [0, 1, 2].map((k) => (x * right[k as 0] + y * up[k as 0] + z * near[k as 0]) / size) as Triple;
}

function mixed(colour: string, other: string, share: number): string {
  const part = (text: string, at: number): number => Number.parseInt(text.slice(at, at + 2), 16);
  const mix = (at: number): string =>
    Math.round(part(colour, at) * (1 - share) + part(other, at) * share).toString(16).padStart(2, "0");
  return `#${mix(1)}${mix(3)}${mix(5)}`;
}
