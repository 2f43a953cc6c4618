/* Hands on the plan: pointers and keys, turned into moves of a gesture that is one step. */

import { arrowOf, dragGrip, dragRobot, drawNew, nudgeGrip, nudgeRobot, turnRobot } from "./moves";
import { withNewCorner } from "./outline";
import type { Plan } from "./plan";
import type { Pair, ProblemData } from "../messages";
import type { Grip } from "./handles";
import { distance } from "./shape";

type Held =
  | { readonly kind: "robot"; readonly name: string; readonly off: Pair }
  | { readonly kind: "grip"; readonly grip: Grip; readonly off: Pair }
  /** A new zone, from here, in the place of what was there before. */
  | { readonly kind: "draw"; readonly from: Pair; readonly before: ProblemData };

/** A press that moves less than this is a click. */
const CLICK = 3;
const BIG = 10;
/** Pixels from a contact of a crowd that take it. */
const NEAR = 12;

export class Hands {
  #held: Held | null = null;
  #pressed: Pair | null = null;
  #moved = false;
  #pointer = -1;
  #keys = false;

  constructor(readonly plan: Plan) {
    const { svg } = plan;
    svg.addEventListener("pointerdown", (event) => this.#down(event));
    svg.addEventListener("pointermove", (event) => this.#move(event));
    svg.addEventListener("pointerup", (event) => this.#up(event));
    svg.addEventListener("pointercancel", () => this.letGo());
    svg.addEventListener("pointerover", (event) => this.#hover(event));
    svg.addEventListener("pointerleave", () => this.plan.context.hover.set(null));
    svg.addEventListener("keydown", (event) => this.#key(event));
    svg.addEventListener("keyup", () => this.#settleKeys());
    svg.addEventListener("focusin", (event) => this.#focus(event));
    svg.addEventListener("focusout", () => {
      this.plan.context.hover.set(null);
      this.#settleKeys();
    });
  }

  get busy(): boolean {
    return this.#held !== null && this.#moved;
  }

  /** Leaves a gesture as if it had not been. */
  letGo(): void {
    if (this.#held === null) return;
    this.#held = null;
    this.plan.context.store.abandon();
  }

  #at(event: PointerEvent): Pair {
    const box = this.plan.svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #down(event: PointerEvent): void {
    if (event.button !== 0 || this.plan.stage === null) return;
    const { stage, context: { store } } = this.plan;
    const at = this.#at(event);
    const target = event.target as Element;
    const knob = target.closest<SVGElement>("[data-knob]");
    const robot = target.closest<SVGElement>("[data-robot]")?.dataset.robot ?? this.#ofCrowd(at);
    this.#pressed = at;
    this.#moved = false;
    if (knob !== null) {
      const { grip, at: middle } = this.plan.handles.knobs[Number(knob.dataset.knob)]!;
      this.#held = { kind: "grip", grip, off: [middle[0] - at[0], middle[1] - at[1]] };
    } else if (robot !== undefined) {
      store.choose(robot);
      const figure = stage.figures.find((one) => one.robot.name === robot);
      if (stage.seen.mode === "move" && (figure !== undefined || stage.crowded)) {
        const [x, y] = figure?.contact ?? at;
        this.#held = { kind: "robot", name: robot, off: [x - at[0], y - at[1]] };
      }
    }
    if (this.#held === null && stage.seen.mode === "edit") this.#held = { kind: "draw", from: at, before: stage.seen.doc.problem };
    if (this.#held === null) return;
    this.#pointer = event.pointerId;
    this.plan.svg.setPointerCapture(event.pointerId);
    event.preventDefault();
    if (this.#held.kind === "draw") return;
    (knob ?? this.plan.robots.of(robot!))?.focus({ preventScroll: true });
  }

  /** One of a crowd, which has no elements, whose contact is near. */
  #ofCrowd(at: Pair): string | undefined {
    const { stage } = this.plan;
    if (stage?.crowded !== true || stage.seen.mode !== "move") return undefined;
    const point = stage.screen.model(at);
    let [nearest, least]: [string | undefined, number] = [undefined, NEAR / stage.screen.scale];
    for (const { name, contact } of stage.seen.doc.problem.swarm.robots) {
      const away = distance(contact, point);
      if (away < least) [nearest, least] = [name, away];
    }
    return nearest === stage.newcomer?.robot.name ? undefined : nearest;
  }

  #move(event: PointerEvent): void {
    if (this.#held === null || event.pointerId !== this.#pointer) return;
    const at = this.#at(event);
    if (!this.#moved && Math.hypot(at[0] - this.#pressed![0], at[1] - this.#pressed![1]) < CLICK) return;
    this.#moved = true;
    const { stage, push, context: { store } } = this.plan;
    const held = { shift: event.shiftKey, alt: event.altKey };
    if (this.#held.kind === "draw") {
      drawNew(store, stage!, this.#held.before, this.#held.from, at, held);
      return;
    }
    const to: Pair = [at[0] + this.#held.off[0], at[1] + this.#held.off[1]];
    if (this.#held.kind === "robot") dragRobot(store, stage!, this.#held.name, stage!.screen.model(to), held);
    else dragGrip(store, stage!, push, this.#held.grip, to, held);
  }

  #up(event: PointerEvent): void {
    const held = this.#held;
    this.#held = null;
    const { store } = this.plan.context;
    if (this.#moved) store.settle();
    else if (held?.kind === "grip" && held.grip.kind === "edge") this.#addCorner(held.grip.edge);
    else if ((held === null || held.kind === "draw") && this.#pressed !== null) this.#click(this.#at(event), event.target as Element);
    this.#pressed = null;
    this.#moved = false;
  }

  /** A click beside everything moves the chosen robot to the outline there, or lets it go. */
  #click(at: Pair, target: Element): void {
    const { stage, context: { store } } = this.plan;
    if (target.closest("[data-robot]") !== null || stage === null) return;
    const zone = target.closest<SVGElement>("[data-zone]")?.dataset.zone;
    const chosen = stage.figures.find(({ robot }) => robot.name === stage.seen.chosen);
    const near = stage.shape.nearest(stage.screen.model(at));
    const close = near.distance * stage.screen.scale < BIG;
    if (stage.seen.mode === "move" && chosen !== undefined && !chosen.robot.mounted && (close || zone !== undefined)) {
      dragRobot(store, stage, chosen.robot.name, near.at, { shift: false, alt: false });
      store.settle();
    } else store.choose(null);
  }

  #addCorner(edge: number): void {
    this.plan.context.store.editProblem((problem) => withNewCorner(problem, edge));
  }

  #hover(event: PointerEvent): void {
    if (this.#held !== null) return;
    const target = event.target as Element;
    const robot = target.closest<SVGElement>("[data-robot]")?.dataset.robot;
    const zone = target.closest<SVGElement>("[data-zone]")?.dataset.zone;
    const { hover } = this.plan.context;
    if (robot !== undefined) hover.set({ kind: "robot", name: robot });
    else if (zone !== undefined) hover.set({ kind: "zone", name: zone });
    else hover.set(null);
  }

  /** A robot that has the focus by keys is the chosen one; what has it is marked everywhere, as under a pointer. */
  #focus(event: FocusEvent): void {
    if (this.#pressed !== null) return;
    const target = event.target as Element;
    const robot = target.closest<SVGElement>("[data-robot]")?.dataset.robot;
    const knob = target.closest<SVGElement>("[data-knob]");
    const { store, hover } = this.plan.context;
    if (target.matches(".robot") && store.seen.value?.chosen !== robot) store.choose(robot!);
    if (robot !== undefined) hover.set({ kind: "robot", name: robot });
    const grip = knob === null ? undefined : this.plan.handles.knobs[Number(knob.dataset.knob)]?.grip;
    if (grip === undefined || !("index" in grip)) return;
    const { zones, no_go } = store.seen.value!.doc.problem;
    const name = grip.kind === "no-go" ? no_go[grip.index]?.name : zones?.[grip.index]?.name;
    if (name !== undefined) hover.set({ kind: "zone", name });
  }

  #key(event: KeyboardEvent): void {
    const { stage, push, context: { store } } = this.plan;
    if (stage === null || event.ctrlKey || event.metaKey) return;
    const by = event.shiftKey ? BIG : 1;
    const target = event.target as Element;
    const knob = target.closest<SVGElement>("[data-knob]");
    const way = arrowOf(event.key);
    if (knob !== null) {
      const { grip } = this.plan.handles.knobs[Number(knob.dataset.knob)]!;
      if (way !== null) nudgeGrip(store, stage, push, grip, way, by);
      else if (grip.kind === "edge" && (event.key === "Enter" || event.key === " ")) this.#addCorner(grip.edge);
      else return;
    } else {
      const name = target.closest<SVGElement>(".robot")?.dataset.robot;
      if (name === undefined) {
        const isNew = target.closest(".newcomer") !== null;
        if (!isNew || (event.key !== " " && event.key !== "Enter") || stage.seen.chosen === stage.newcomer?.robot.name) return;
        store.choose(stage.newcomer!.robot.name);
      } else if (way !== null) nudgeRobot(store, stage, name, way, by);
      else if (event.key === "[" || event.key === "{") turnRobot(store, stage, name, by);
      else if (event.key === "]" || event.key === "}") turnRobot(store, stage, name, -by);
      else return;
    }
    this.#keys = true;
    event.preventDefault();
    event.stopPropagation();
  }

  #settleKeys(): void {
    if (!this.#keys) return;
    this.#keys = false;
    this.plan.context.store.settle();
  }
}
