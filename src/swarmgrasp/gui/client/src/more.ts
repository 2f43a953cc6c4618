/* What else a robot is: its bounds, its tolerance, its body, the directions it must not push in. */

import { stepOf } from "./bar";
import type { Context } from "./context";
import { el, Pool, put, show, write } from "./dom";
import type { BodyData, NewcomerData, Pair, ProblemData, RobotData, ToleranceData } from "./messages";
import { gapsOf, isAllRound, withEnd, withGaps, withNewGap } from "./plan/gaps";
import { figure } from "./speech";
import { Spin, Word, type SpinOptions } from "./spin";

const DEGREE = Math.PI / 180;
/** Beam of a new body, of its length. */
const BEAM = 0.4;
const EXACT: ToleranceData = { contact: [0, 0], direction: [0, 0], least_limit: null, may_be_absent: false };

/** What a robot and a newcomer both have. */
type Either = RobotData | NewcomerData;
type Edit<R> = (change: (one: R) => R, moving: boolean) => void;
/** One that fits either. */
type EditEither = (change: <E extends Either>(one: E) => E, moving: boolean) => void;

export class More {
  readonly node = el("div", { class: "inspect-more", role: "group", "aria-label": "More of it", hidden: true });
  readonly button = el("button", { type: "button", class: "control more-button", "aria-expanded": "false" }, "More");
  readonly #spins = {
    least: new Spin(), friction: new Spin(), astern: new Spin(), along: new Spin(), turn: new Spin(),
    sure: new Spin(), length: new Spin(), beam: new Spin(),
  };
  readonly #absent = new Word();
  readonly #steers = new Word();
  readonly #mounted = new Word();
  readonly #group = el("input", { class: "control more-group", spellcheck: "false", placeholder: "none" });
  readonly #grouped = el("label", { class: "more-part" }, "fails together with group ", this.#group);
  readonly #body: HTMLElement;
  readonly #gapRow = el("div", { class: "more-part" });
  readonly #gaps: Pool<HTMLElement, Pair>;
  readonly #gapSpins = new WeakMap<HTMLElement, readonly [Spin, Spin]>();
  readonly #newGap = el("button", { type: "button", class: "control" }, "Add a gap");
  #dressGap: (node: HTMLElement, gap: Pair, index: number) => void = () => undefined;
  #open = false;
  #at: Pair | null = null;
  #addGap: () => void = () => undefined;
  #regroup: (group: string) => void = () => undefined;

  constructor(readonly context: Context) {
    const { least, friction, astern, along, turn, sure, length, beam } = this.#spins;
    this.#body = part("takes up", length.node, beam.node);
    this.#gaps = new Pool(el("div", { class: "more-part" }), () => this.#makeGap(), (node, gap, i) => this.#dressGap(node, gap, i));
    this.#gapRow.append("does not push", this.#gaps.parent, this.#newGap);
    this.node.append(
      part(this.#steers.node, this.#mounted.node, least.node, astern.node, friction.node), this.#gapRow,
      part("where it is, to within", along.node, "and", turn.node), part("its force is sure up to", sure.node, this.#absent.node),
      this.#body, this.#grouped,
    );
    this.button.addEventListener("click", () => this.toggle());
    this.#newGap.addEventListener("click", () => this.#addGap());
    this.#group.addEventListener("change", () => this.#regroup(this.#group.value.trim()));
    this.#group.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.#regroup(this.#group.value.trim());
      event.stopPropagation();
    });
  }

  toggle(): void {
    this.#open = !this.#open;
    put(this.button, { "aria-expanded": String(this.#open) });
    this.place(this.#at);
  }

  /** Shows it, if it is open, away from who is chosen: that is what is looked at. */
  place(at: Pair | null): void {
    this.#at = at;
    show(this.node, this.#open && at !== null);
    if (this.#open) put(this.node, { "data-above": at !== null && at[1] > this.node.parentElement!.clientHeight / 2 });
  }

  drawRobot(robot: RobotData, edit: Edit<RobotData>): void {
    const isLine = robot.envelope === null && robot.lever === 0;
    this.#drawEither(robot, edit as EditEither);
    this.#force("least", isLine && robot.sectors === null, robot.least, robot.limit, "at least",
      (least, moving) => edit((one) => ({ ...one, least }), moving));
    // A finger pushes, and is no propeller.
    const fingers = isLine && robot.steers === 0 && robot.sectors === null && !robot.mounted;
    this.#rub(fingers, robot.friction, (friction, moving) => edit((one) => ({ ...one, friction }), moving));
    show(this.#spins.astern.node, isLine && robot.sectors === null && robot.friction === null);
    for (const { node } of [this.#steers, this.#mounted]) show(node, false);
    show(this.#grouped, true);
    if (!this.#group.matches(":focus")) this.#group.value = robot.group;
    this.#regroup = (group) => edit((one) => (one.group === group ? one : { ...one, group }), false);
    this.#drawGaps(robot, edit);
    show(this.#body, !robot.mounted);
  }

  drawNewcomer(newcomer: NewcomerData, edit: Edit<NewcomerData>): void {
    this.#drawEither(newcomer, edit as EditEither);
    show(this.#spins.least.node, false);
    this.#rub(!newcomer.steers && !newcomer.mounted, newcomer.friction,
      (friction, moving) => edit((one) => (friction === null ? { ...one, friction } : { ...one, friction, attachment: "push", reverse_limit: 0 }), moving));
    show(this.#spins.astern.node, newcomer.friction === null);
    for (const { node } of [this.#steers, this.#mounted]) show(node, true);
    this.#steers.draw(newcomer.steers ? "steers" : "one direction", newcomer.steers, "Whether it turns its force at any time",
      () => edit((one) => ({ ...one, steers: !one.steers }), false));
    this.#mounted.draw(newcomer.mounted ? "inside" : "on the outline", newcomer.mounted, "Where it is placed",
      () => this.context.store.editProblem(insideOrOut));
    show(this.#grouped, false);
    show(this.#gapRow, false);
    show(this.#body, !newcomer.mounted);
  }

  // -- what both have -------------------------------------------------------------------------

  #drawEither(one: Either, edit: EditEither): void {
    const tolerance = one.tolerance ?? EXACT;
    const { along, turn } = this.#spins;
    const { size, label } = this.context.speech.value.data.length;
    const set = (change: Partial<ToleranceData>, moving: boolean): void =>
      edit((now) => ({ ...now, tolerance: tolerant({ ...(now.tolerance ?? EXACT), ...change }) }), moving);
    const reach = ([a, b]: Pair, unit: number): number => Math.max(-a, b) / unit;
    along.draw(reach(tolerance.contact, size), this.#spin({
      label: "How far along the outline it may be", min: 0, max: Infinity, step: size === 1 ? 0.1 : 0.5,
      text: (value) => `±${figure(value, value === 0 ? 0 : 1)}\u00a0${label}`,
      change: (value, moving) => set({ contact: [-value * size, value * size] }, moving),
    }));
    turn.draw(reach(tolerance.direction, DEGREE), this.#spin({
      label: "How far its direction may be off", min: 0, max: 180, step: 1, text: (value) => `±${figure(value, value % 1 === 0 ? 0 : 1)}°`,
      change: (value, moving) => set({ direction: [-value * DEGREE, value * DEGREE] }, moving),
    }));
    this.#force("sure", true, tolerance.least_limit ?? one.limit, one.limit, "",
      (least, moving) => set({ least_limit: least >= one.limit ? null : least }, moving));
    this.#absent.draw(tolerance.may_be_absent ? "may be absent" : "surely there", tolerance.may_be_absent, "Whether it may not be there at all",
      () => set({ may_be_absent: !tolerance.may_be_absent }, false));
    this.#force("astern", true, one.reverse_limit, one.limit, "astern",
      (limit, moving) => edit((now) => ({ ...now, reverse_limit: limit }), moving));
    this.#drawBody(one.body, (body, moving) => edit((now) => ({ ...now, body }), moving));
  }

  #drawBody(body: BodyData | null, set: (body: BodyData | null, moving: boolean) => void): void {
    const { size, label } = this.context.speech.value.data.length;
    const text = (value: number): string => (value === 0 ? "no room" : `${figure(value, 1)}\u00a0${label}`);
    this.#spins.length.draw((body?.length ?? 0) / size, this.#spin({
      label: "Length of its body, away from the outline", min: 0, max: Infinity, step: 1, text, ...(body === null ? {} : { after: "long" }),
      change: (value, moving) => set(value <= 0 ? null : { length: value * size, beam: body?.beam ?? BEAM * value * size }, moving),
    }));
    const { beam } = this.#spins;
    show(beam.node, body !== null);
    if (body === null) return;
    beam.draw(body.beam / size, this.#spin({
      label: "Beam of its body", min: 0.01, max: Infinity, step: 0.5, text, after: "wide",
      change: (value, moving) => set({ ...body, beam: value * size }, moving),
    }));
  }

  // -- controls ------------------------------------------------------------------------------

  #spin(options: Omit<SpinOptions, "settle">): SpinOptions {
    return { ...options, settle: () => this.context.store.settle() };
  }

  #force(name: "least" | "sure" | "astern", shown: boolean, force: number, limit: number, after: string, set: (force: number, moving: boolean) => void): void {
    const spin = this.#spins[name];
    show(spin.node, shown);
    const unit = this.context.speech.value.forceUnit(limit);
    spin.draw(force / unit.size, this.#spin({
      label: { least: "Least force", sure: "Force that is sure", astern: "Limit astern" }[name], min: 0, max: name === "astern" ? Infinity : limit / unit.size,
      step: stepOf(limit / unit.size), text: (value) => `${figure(value)}\u00a0${unit.label}`, ...(after === "" ? {} : { after }),
      change: (value, moving) => set(value * unit.size, moving),
    }));
  }

  #rub(shown: boolean, friction: number | null, set: (friction: number | null, moving: boolean) => void): void {
    show(this.#spins.friction.node, shown);
    this.#spins.friction.draw(friction ?? 0, this.#spin({
      label: "Coefficient of friction", min: 0, max: 10, step: 0.05, text: (value) => (value === 0 ? "no" : figure(value, 2)), after: "friction",
      change: (value, moving) => set(value === 0 ? null : value, moving),
    }));
  }

  // -- gaps ----------------------------------------------------------------------------------

  #makeGap(): HTMLElement {
    const spins = [new Spin(), new Spin()] as const;
    const node = el("span", { class: "more-part" }, "from", spins[0].node, "to", spins[1].node);
    this.#gapSpins.set(node, spins);
    return node;
  }

  #drawGaps(robot: RobotData, edit: Edit<RobotData>): void {
    show(this.#gapRow, isAllRound(robot));
    if (!isAllRound(robot)) return;
    const gaps = gapsOf(robot);
    const { value: speech } = this.context.speech;
    this.#addGap = () => edit(withNewGap, false);
    this.#dressGap = (node, gap, index) => {
      // Bearings are clockwise: the gap's second end comes first.
      ([1, 0] as const).forEach((end, k) => {
        this.#gapSpins.get(node)![k]!.draw(Math.round(speech.told(-gap[end]) / DEGREE) % 360, this.#spin({
          label: `${k === 0 ? "Start" : "End"} of gap ${index + 1}`, min: 0, max: 360, step: 5, wraps: true,
          text: (value) => `${String(Math.round(value) % 360).padStart(3, "0")}°`,
          change: (value, moving) => {
            const to = -speech.untold(value * DEGREE);
            edit((one) => withGaps(one, gapsOf(one).map((other, i) => (i === index ? withEnd(other, end, to, moving) : other))), moving);
          },
        }));
      });
    };
    this.#gaps.draw(gaps);
    write(this.#newGap, gaps.length === 0 ? "Add a gap" : "Another gap");
  }
}

/** The same problem with a newcomer inside, or on the outline again: zones are areas, or stretches. */
function insideOrOut(problem: ProblemData): ProblemData {
  const mounted = !problem.newcomer.mounted;
  const zones = problem.zones?.filter((zone) => (zone.area !== null) === mounted) ?? [];
  const newcomer = mounted ? { ...problem.newcomer, mounted, attachment: "free" as const, half_angle: null, friction: null, body: null }
    : { ...problem.newcomer, mounted, attachment: "push" as const, half_angle: Math.PI / 6 };
  return { ...problem, newcomer, zones: zones.length > 0 ? zones : null, ...(mounted ? { no_go: [], spacing: 0 } : {}) };
}

/** Null where it is exact. */
function tolerant(tolerance: ToleranceData): ToleranceData | null {
  const { contact, direction, least_limit, may_be_absent } = tolerance;
  const exact = [...contact, ...direction].every((offset) => Math.abs(offset) === 0) && least_limit === null && !may_be_absent;
  return exact ? null : tolerance;
}

function part(...children: (HTMLElement | string)[]): HTMLElement {
  return el("div", { class: "more-part" }, ...children);
}
