/* Many robots at once, on a canvas: arrows up to a few hundred, above that how much force there is along the side. */

import type { Pair, RobotData } from "../messages";
import type { Stage } from "./stage";
import { figureOf } from "./figures";
import { stanceOf } from "./stance";

/** From so many robots on, bars take the place of arrows. */
const BARS_FROM = 400;
/** Pixels of outline for a bar, and between hairs. */
const BAR = 5;
const HAIR = 20;
const OFF = 13;
const LONGEST = 46;

export class Crowd {
  readonly canvas = document.createElement("canvas");
  #drawn: { robots: readonly RobotData[]; key: string } | null = null;

  constructor() {
    this.canvas.className = "crowd";
    this.canvas.setAttribute("aria-hidden", "true");
  }

  draw(stage: Stage): void {
    this.canvas.hidden = !stage.crowded;
    if (!stage.crowded) {
      this.#drawn = null;
      return;
    }
    const { screen, seen } = stage;
    const { robots } = seen.doc.problem.swarm;
    const colours = getComputedStyle(this.canvas);
    const ratio = window.devicePixelRatio;
    const key = `${screen.width} ${screen.height} ${ratio} ${colours.color} ${seen.chosen} ${seen.mode}`;
    if (this.#drawn?.robots === robots && this.#drawn.key === key) return;
    this.#drawn = { robots, key };
    this.canvas.width = Math.round(screen.width * ratio);
    this.canvas.height = Math.round(screen.height * ratio);
    const pen = this.canvas.getContext("2d");
    if (pen === null) return;
    pen.scale(ratio, ratio);
    pen.strokeStyle = colours.color;
    pen.fillStyle = colours.color;
    if (robots.length > BARS_FROM) this.#bars(pen, stage, robots);
    else this.#arrows(pen, stage, robots);
  }

  #arrows(pen: CanvasRenderingContext2D, stage: Stage, robots: readonly RobotData[]): void {
    pen.lineWidth = 1.4;
    pen.globalAlpha = 0.85;
    for (const robot of robots) {
      const { from, to, contact } = figureOf(robot, false, stage.shape, stage.screen, stage.scale);
      pen.beginPath();
      pen.moveTo(...from);
      pen.lineTo(...to);
      pen.stroke();
      head(pen, from, to);
      pen.beginPath();
      pen.arc(contact[0], contact[1], 1.8, 0, 2 * Math.PI);
      pen.fill();
    }
  }

  /** Bars of force, outwards, and a hair for the mean direction. */
  #bars(pen: CanvasRenderingContext2D, { shape, screen }: Stage, robots: readonly RobotData[]): void {
    const bins = shape.vertices.map((_, edge) => {
      const count = Math.max(1, Math.round((shape.lengthOf(edge) * screen.scale) / BAR));
      return Array.from({ length: count }, () => ({ force: 0, x: 0, y: 0 }));
    });
    for (const robot of robots) {
      if (robot.mounted) continue;
      const { along, edge } = stanceOf(shape, robot);
      const row = bins[edge]!;
      const share = (along - shape.starts[edge]!) / shape.lengthOf(edge);
      const bin = row[Math.max(0, Math.min(row.length - 1, Math.floor(share * row.length)))]!;
      bin.force += robot.limit;
      bin.x += robot.limit * Math.cos(robot.direction);
      bin.y += robot.limit * Math.sin(robot.direction);
    }
    const most = Math.max(...bins.flat().map(({ force }) => force), 1e-300);
    bins.forEach((row, edge) => {
      const out = shape.inward(edge) + Math.PI;
      const step = shape.lengthOf(edge) / row.length;
      row.forEach(({ force, x, y }, i) => {
        if (force === 0) return;
        const base = screen.step(screen.at(shape.onEdge(edge, (i + 0.5) * step)), out, OFF);
        pen.lineWidth = step * screen.scale * 0.72;
        pen.globalAlpha = 0.75;
        line(pen, base, screen.step(base, out, (LONGEST * force) / most));
        if (i % Math.round(HAIR / BAR) !== 0) return;
        const away = Math.cos(Math.atan2(y, x) - out) > 0 ? 1 : -1;
        const tip = screen.step(base, out, LONGEST + 10);
        pen.lineWidth = 1;
        line(pen, tip, screen.step(tip, Math.atan2(away * y, away * x), 18));
      });
    });
    pen.globalAlpha = 1;
  }
}

function line(pen: CanvasRenderingContext2D, from: Pair, to: Pair): void {
  pen.beginPath();
  pen.moveTo(...from);
  pen.lineTo(...to);
  pen.stroke();
}

function head(pen: CanvasRenderingContext2D, from: Pair, to: Pair): void {
  const way = Math.atan2(to[1] - from[1], to[0] - from[0]);
  pen.beginPath();
  pen.moveTo(...to);
  for (const turn of [2.7, -2.7]) pen.lineTo(to[0] + 6 * Math.cos(way + turn), to[1] + 6 * Math.sin(way + turn));
  pen.fill();
}
