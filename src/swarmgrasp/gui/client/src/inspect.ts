/* The bar of whoever is chosen: its numbers, and what can be done with it. */

import type { Context, Seen, View } from "./context";
import { el, iconButton, put, show, write } from "./dom";
import { keepNewcomer } from "./keeping";
import type { Attachment, NewcomerData, Pair, RobotData } from "./messages";
import { More } from "./more";
import type { Plan } from "./plan/plan";
import { duplicated, withoutRobot, withRobots } from "./plan/adding";
import { alongEdge, movedAlong, movedInside, reversed, stanceOf, turnedOff } from "./plan/stance";
import { figure, signed } from "./speech";
import { Spin, Word, type SpinOptions } from "./spin";
import { stepOf } from "./bar";

const DEGREE = Math.PI / 180;
const WAYS: readonly Attachment[] = ["push", "pull", "free"];
const WAY_WORDS = { push: "pushes", pull: "pulls", free: "any way" } as const;

export class Inspector implements View {
  readonly node = el("div", { class: "inspect", role: "group", hidden: true });
  readonly #name = el("input", { class: "inspect-name", "aria-label": "Name", spellcheck: "false" });
  readonly #where = el("span", { class: "inspect-where" });
  readonly #spins = [new Spin(), new Spin(), new Spin(), new Spin(), new Spin(), new Spin()] as const;
  readonly #way = new Word();
  readonly #keep = el("button", { type: "button", class: "control keep" }, "Keep it");
  readonly more: More;
  readonly #copy: HTMLButtonElement;
  readonly #remove: HTMLButtonElement;

  constructor(readonly plan: Plan, readonly context: Context) {
    const [along, off, limit, steers, reverse, across] = this.#spins.map((spin) => spin.node);
    this.#copy = iconButton("copy", "Another one beside it", () => this.duplicate());
    this.#remove = iconButton("remove", "Take it away", () => this.remove());
    this.more = new More(context);
    this.node.append(
      this.#name, this.#where, along!, across!, this.#way.node, off!, limit!, steers!, reverse!, this.more.button,
      this.#keep, this.#copy, this.#remove,
    );
    this.#keep.addEventListener("click", () => this.keep());
    this.#name.addEventListener("change", () => this.#rename(this.#name.value.trim()));
    this.#name.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === "Escape") this.#name.blur();
      event.stopPropagation();
    });
    plan.card.append(this.more.node, this.node);
  }

  draw(seen: Seen): void {
    const robot = this.robot;
    const newcomer = this.#isNewcomer ? seen.doc.problem.newcomer : null;
    show(this.node, this.plan.stage !== null && seen.mode === "move" && (robot !== null || newcomer !== null));
    this.more.place(this.node.hidden ? null : this.#contact(robot, seen));
    if (this.node.hidden) return;
    const name = robot?.name ?? newcomer!.name;
    put(this.node, { "aria-label": name, class: newcomer === null ? "inspect" : "inspect inspect-new" });
    if (this.#name.ownerDocument.activeElement !== this.#name && !this.#name.matches(":focus")) this.#name.value = name;
    put(this.#name, { size: Math.max(3, name.length) });
    show(this.#keep, newcomer !== null);
    show(this.#copy, robot !== null);
    show(this.#remove, robot !== null);
    if (robot !== null) this.#drawRobot(robot);
    else this.#drawNewcomer(newcomer!);
  }

  /** What is so now, drawn or not: a key may come before the frame. */
  get #now(): Seen | null {
    return this.context.store.seen.value;
  }

  /** The robot that is chosen. */
  get robot(): RobotData | null {
    const now = this.#now;
    return now?.doc.problem.swarm.robots.find(({ name }) => name === now.chosen) ?? null;
  }

  get #isNewcomer(): boolean {
    const { doc, chosen } = this.#now!;
    return doc.newcomer && chosen !== null && chosen === doc.problem.newcomer.name && this.robot === null;
  }

  /** Where who is chosen stands on the card; null where nobody has been placed. */
  #contact(robot: RobotData | null, seen: Seen): Pair | null {
    const at = robot ?? seen.parts.answer?.newcomer;
    return at == null ? null : this.plan.stage!.screen.at(at.contact);
  }

  flip(): void {
    const { store } = this.context;
    if (this.robot !== null) store.editRobot(this.robot.name, reversed);
    else if (this.#now !== null && this.#isNewcomer) this.#nextWay();
  }

  /** Changes the limit by whole units. */
  strengthen(by: number): void {
    const robot = this.robot ?? (this.#now !== null && this.#isNewcomer ? this.#now.doc.problem.newcomer : null);
    if (robot === null) return;
    const unit = this.context.speech.value.forceUnit(robot.limit).size;
    const step = stepOf(robot.limit / unit) * unit;
    const limit = Math.max(step, Math.round(robot.limit / step + by) * step);
    if (this.robot !== null) this.context.store.editRobot(robot.name, (one) => ({ ...one, limit }), true);
    else this.context.store.editNewcomer((one) => ({ ...one, limit }), true);
  }

  duplicate(): void {
    const { robot, plan: { stage } } = this;
    if (robot === null || stage === null) return;
    const { doc } = this.#now!;
    const gap = Math.max(doc.problem.spacing, 24 / stage.screen.scale);
    const copy = duplicated(stage.shape, doc, robot, gap);
    this.context.store.edit((doc) => withRobots(doc, [copy]));
    this.context.store.choose(copy.name);
  }

  remove(): void {
    const { robot } = this;
    if (robot === null) return;
    this.context.store.edit((doc) => withoutRobot(doc, robot.name));
    this.context.toast(`${robot.name} is taken away.`, { word: "Undo", run: () => this.context.store.undo() });
  }

  /** Makes the newcomer a robot at its best place, and asks for the next. */
  keep(): void {
    const best = this.#now?.parts.answer?.newcomer ?? null;
    if (best !== null) keepNewcomer(this.context, best);
  }

  #rename(name: string): void {
    const { store } = this.context;
    if (name === "" || name === this.#now!.chosen) return;
    const { robot } = this;
    if (robot !== null) store.editRobot(robot.name, (one) => ({ ...one, name }));
    else store.editNewcomer((one) => ({ ...one, name }));
    store.choose(name);
  }

  #spin(options: Omit<SpinOptions, "settle">): SpinOptions {
    return { ...options, settle: () => this.context.store.settle() };
  }

  #drawRobot(robot: RobotData): void {
    const [along, off, limit, steers, reverse, across] = this.#spins;
    const { store, speech: { value: speech } } = this.context;
    const { shape } = this.plan.stage!;
    const { size, label } = speech.data.length;
    const edit = (change: (one: RobotData) => RobotData, moving: boolean): void => store.editRobot(robot.name, change, moving);
    const stance = robot.mounted ? null : stanceOf(shape, robot);
    write(this.#where, stance === null ? "" : shape.nameOf(stance.edge));
    show(across.node, stance === null);
    if (stance !== null) {
      const start = shape.starts[stance.edge]!;
      along.draw(alongEdge(shape, stance) / size, this.#spin({
        label: "How far along its side", min: -Infinity, max: Infinity, step: speech.data.length.unit === "m" && shape.perimeter < 20 ? 0.01 : 1,
        text: (value) => `${figure(value, size * shape.perimeter < 20 ? 2 : 1)}\u00a0${label}`, after: "along",
        change: (value, moving) => edit((one) => movedAlong(shape, one, start + value * size), moving),
      }));
    } else {
      const [x, y] = speech.toFile(robot.contact);
      ([[along, 0, "First coordinate"], [across, 1, "Second coordinate"]] as const).forEach(([spin, axis, told]) => {
        spin.draw([x, y][axis]!, this.#spin({
          label: told, min: -Infinity, max: Infinity, step: stepOf(shape.perimeter / size / 100), text: (value) => `${figure(value, 2)}\u00a0${label}`,
          change: (value, moving) => edit((one) => {
            const at = speech.toFile(one.contact);
            at[axis] = value;
            return movedInside(shape, one, speech.fromFile(at));
          }, moving),
        }));
      });
    }
    show(this.#way.node, robot.steers < Math.PI);
    this.#way.draw(stance === null ? "turn round" : stance.pushes ? "pushes" : "pulls", true, "Which way", () => this.flip());
    show(off.node, robot.steers < Math.PI);
    off.draw((stance?.off ?? robot.direction) / DEGREE, this.#spin({
      label: stance === null ? "Direction, counter-clockwise from the bow" : "Degrees off square", min: -180, max: 180, step: 1,
      text: (value) => `${signed(value)}°`, after: stance === null ? "" : "off square",
      change: (value, moving) => edit((one) => turnedOff(shape, one, value * DEGREE), moving),
    }));
    this.#drawForces(robot, limit, reverse, edit);
    this.more.drawRobot(robot, edit);
    show(steers.node, robot.envelope === null && robot.sectors === null && (robot.friction ?? 0) === 0);
    steers.draw(robot.steers / DEGREE, this.#spin({
      label: "How far it steers either side", min: 0, max: 180, step: 5, text: (value) => (value >= 180 ? "all round" : `±${figure(value, 0)}°`), after: "steers",
      change: (value, moving) => edit((one) => ({ ...one, steers: value * DEGREE }), moving),
    }));
  }

  #drawForces(robot: RobotData, limit: Spin, reverse: Spin, edit: (change: (one: RobotData) => RobotData, moving: boolean) => void): void {
    const unit = this.context.speech.value.forceUnit(robot.limit);
    const text = (value: number): string => `${figure(value)}\u00a0${unit.label}`;
    const step = stepOf(robot.limit / unit.size);
    show(limit.node, robot.envelope === null);
    limit.draw(robot.limit / unit.size, this.#spin({
      label: "Limit", min: Number.MIN_VALUE, max: Infinity, step, text, after: "limit",
      change: (value, moving) => edit((one) => ({ ...one, limit: value * unit.size }), moving),
    }));
    show(reverse.node, robot.reverse_limit > 0);
    reverse.draw(robot.reverse_limit / unit.size, this.#spin({
      label: "Limit the other way", min: 0, max: Infinity, step, text, after: "astern",
      change: (value, moving) => edit((one) => ({ ...one, reverse_limit: value * unit.size }), moving),
    }));
  }

  #drawNewcomer(newcomer: NewcomerData): void {
    const [along, off, limit, steers, reverse, across] = this.#spins;
    for (const spin of [along, steers, reverse, across]) show(spin.node, false);
    show(this.#way.node, true);
    write(this.#where, newcomer.mounted ? "inside" : "comes");
    this.more.drawNewcomer(newcomer, (change, moving) => this.context.store.editNewcomer(change, moving));
    this.#way.draw(WAY_WORDS[newcomer.attachment], true, "Push, pull or any way", () => this.#nextWay());
    show(off.node, newcomer.attachment !== "free");
    const { store, speech: { value: speech } } = this.context;
    off.draw((newcomer.half_angle ?? Math.PI / 2) / DEGREE, this.#spin({
      label: "How far off square it may be", min: 0, max: 90, step: 1, text: (value) => `±${figure(value, 0)}°`, after: "off square",
      change: (value, moving) => store.editNewcomer((one) => ({ ...one, half_angle: value * DEGREE }), moving),
    }));
    const unit = speech.forceUnit(newcomer.limit);
    show(limit.node, true);
    limit.draw(newcomer.limit / unit.size, this.#spin({
      label: "Limit", min: Number.MIN_VALUE, max: Infinity, step: stepOf(newcomer.limit / unit.size),
      text: (value) => `${figure(value)}\u00a0${unit.label}`, after: "limit",
      change: (value, moving) => store.editNewcomer((one) => ({ ...one, limit: value * unit.size }), moving),
    }));
  }

  #nextWay(): void {
    this.context.store.editNewcomer((one) => {
      const attachment = WAYS[(WAYS.indexOf(one.attachment) + 1) % WAYS.length]!;
      return { ...one, attachment, half_angle: attachment === "free" ? null : one.half_angle ?? Math.PI / 6 };
    });
  }
}
