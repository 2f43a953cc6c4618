/* The plan: the hull from above, and everything on it that can be seen and moved. */

import type { Context, Seen, View } from "../context";
import { put, show, svg, write, el } from "../dom";
import type { OutlineData, Pair, RobotData } from "../messages";
import { Crowd } from "./crowd";
import { HandleLayer, outlineKnobs, robotKnobs, zoneKnobs, type Knob } from "./handles";
import { Hands } from "./hands";
import { HullLayer, ScaleLayer } from "./hull";
import { MiddleLayer } from "./middle";
import type { Box } from "./labels";
import { NameLayer } from "./names";
import { PushLayer } from "./push";
import { NewcomerLayer, RobotLayer } from "./robots";
import { Screen } from "./screen";
import { Shape } from "./shape";
import { stageOf, type Stage } from "./stage";
import { Weather } from "./weather";
import { figureOf } from "./figures";

/** Room under the hull for the bar of the chosen robot, where the card is low or narrow. */
const LOW = 430;
const NARROW = 520;
const LIFT = 44;
const OVERLAP = 12;
const BARS = ".inspect:not([hidden]), .inspect-more:not([hidden])";
/** Room round a knob. */
const KNOB = 9;

/** Where another view may draw on the plan. */
export interface PlanLayer {
  readonly group: SVGGElement;
  toScreen(at: Pair): Pair;
  readonly turned: boolean;
}

export class Plan implements View {
  readonly svg = svg("svg", { class: "plan-svg", role: "group", "aria-label": "Plan of the hull and its robots" });
  readonly robots = new RobotLayer();
  readonly handles = new HandleLayer();
  readonly push: PushLayer;
  readonly newcomer = new NewcomerLayer();
  readonly hands: Hands;
  readonly layer: PlanLayer;
  /** Names are placed last, where the bars of the plan leave room. */
  readonly names: View = { draw: (seen) => this.#drawNames(seen) };
  /** What newcomers after the first would do. */
  later: readonly RobotData[] = [];
  /** The first of those that are placed together: not always where it would go alone. */
  together: RobotData | null = null;
  readonly #hull = new HullLayer();
  readonly #middle = new MiddleLayer();
  readonly #labels = new NameLayer();
  readonly #scale = new ScaleLayer();
  readonly #weather = new Weather();
  readonly #crowd = new Crowd();
  readonly #shares = el("div", { class: "push-words", role: "status" });
  #shape: { of: OutlineData; shape: Shape } | null = null;
  #stage: Stage | null = null;
  #focus: string | null = null;
  /** Where the bars of who is chosen were when the hand last rested: to measure them takes time. */
  #bars: readonly Box[] = [];

  constructor(readonly card: HTMLElement, readonly context: Context) {
    this.push = new PushLayer(context);
    const slopes = svg("g", { class: "slopes" });
    this.svg.append(
      this.#hull.group, this.#middle.group, slopes, this.robots.group, this.newcomer.group,
      this.#labels.group, this.push.group, this.handles.group, this.#scale.group,
    );
    card.prepend(this.#crowd.canvas, this.svg, this.#weather.node, this.#shares);
    const plan = this;
    this.layer = {
      group: slopes,
      toScreen: (at) => plan.#stage?.screen.at(at) ?? [0, 0],
      get turned() {
        return plan.#stage?.screen.turned ?? false;
      },
    };
    this.hands = new Hands(this);
    new ResizeObserver(() => this.#redraw()).observe(card);
    context.hover.listen(() => this.#redraw());
  }

  get stage(): Stage | null {
    return this.#stage;
  }

  /** Gives a robot the keys as soon as it is drawn. */
  focus(name: string): void {
    this.#focus = name;
  }

  draw(seen: Seen): void {
    const width = this.card.clientWidth;
    // On phones the sheet lies over the card's last pixels.
    const height = this.card.clientHeight - (width === this.context.root.clientWidth ? OVERLAP : 0);
    if (width <= 0 || height <= 0) return;
    const bar = this.context.root.querySelector<HTMLElement>(".plan .timeline:not([hidden])");
    const lift = ((height < LOW || width < NARROW) && seen.chosen !== null ? LIFT : 0) + (bar === null ? 0 : 56);
    const screen = new Screen(this.#shapeOf(seen.doc.problem.swarm.outline), width, height, lift);
    const stage = stageOf(seen, this.#shape!.shape, screen, this.context.speech.value, this.context.hover.value, this.together);
    this.#stage = stage;
    put(this.svg, { viewBox: `0 0 ${width} ${height}`, width, height, class: `plan-svg mode-${seen.mode}${stage.scale.many ? " many" : ""}` });
    this.#crowd.draw(stage);
    this.#hull.draw(stage);
    this.#middle.draw(stage);
    this.robots.draw(stage);
    this.newcomer.draw(stage, this.later);
    this.push.draw(stage);
    this.handles.draw(this.#knobs(stage));
    this.#weather.draw(stage);
    this.#scale.draw(stage, seen.chosen !== null && width < 1100);
    this.#drawShares(seen);
    if (this.#focus !== null) this.robots.of(this.#focus)?.focus();
    this.#focus = null;
  }

  #redraw(): void {
    const seen = this.context.store.seen.value;
    if (seen === null) return;
    this.draw(seen);
    this.names.draw(seen);
  }

  #drawNames({ mode, chosen }: Seen): void {
    const stage = this.#stage;
    if (stage === null) return;
    const later = this.later.map((robot) => figureOf(robot, true, stage.shape, stage.screen, stage.scale));
    this.#labels.draw(stage, mode === "push" ? [] : later, this.#kept(stage, chosen !== null));
  }

  #shapeOf(outline: OutlineData): Shape {
    if (this.#shape?.of !== outline) this.#shape = { of: outline, shape: new Shape(outline) };
    return this.#shape.shape;
  }

  #knobs(stage: Stage): Knob[] {
    const { seen } = stage;
    if (seen.mode === "edit") return zoneKnobs(stage);
    if (seen.mode === "outline") return outlineKnobs(stage);
    if (seen.mode === "push") return this.push.knobs();
    const half = seen.doc.problem.newcomer.half_angle ?? Math.PI / 2;
    const fan = this.newcomer.fanSides().map(({ at, sign }): Knob => ({
      grip: { kind: "fan", sign }, at, label: `How far off square ${seen.doc.problem.newcomer.name} may be`,
      value: (half * 180) / Math.PI, text: stage.speech.angle(half).replace("+", "±"),
    }));
    return [...robotKnobs(stage), ...fan];
  }

  /** Corners of the card that are taken. */
  #kept({ screen: { width, height }, seen }: Stage, chosen: boolean): Box[] {
    const kept: Box[] = [];
    if (seen.doc.in_weather) kept.push({ left: 12, top: 12, right: width < NARROW ? 76 : 236, bottom: 84 });
    if (width >= NARROW) {
      kept.push({ left: 16, top: height - 44, right: 240, bottom: height });
      kept.push({ left: width - 270, top: 0, right: width, bottom: 52 });
    } else kept.push({ left: width - 84, top: 0, right: width, bottom: 34 });
    if (!chosen) return kept;
    for (const { at: [x, y] } of this.handles.knobs) kept.push({ left: x - KNOB, top: y - KNOB, right: x + KNOB, bottom: y + KNOB });
    if (!seen.moving) this.#bars = [...this.card.querySelectorAll<HTMLElement>(BARS)].map(boxOfBar);
    return [...kept, ...this.#bars];
  }

  #drawShares(seen: Seen): void {
    const on = seen.mode === "push" && seen.forces !== null;
    show(this.#shares, on);
    if (!on) return;
    write(this.#shares, seen.forces!.say);
    put(this.#shares, { class: seen.forces!.held ? "push-words" : "push-words unreached" });
  }
}

function boxOfBar({ offsetLeft: left, offsetTop: top, offsetWidth, offsetHeight }: HTMLElement): Box {
  return { left: left - 8, top: top - 4, right: left + offsetWidth, bottom: top + offsetHeight };
}
