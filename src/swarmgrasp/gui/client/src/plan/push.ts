/* The wanted wrench: an arrow for its force and a ring for its turn, and who is asked to give it. */

import type { Context } from "../context";
import { put, svg } from "../dom";
import type { Pair, Triple } from "../messages";
import { arcPath, arrow } from "./figures";
import type { Knob } from "./handles";
import type { Stage } from "./stage";
import { path } from "./screen";

/** Pixels of a force as large as all robots together. */
const REACH = 170;
const RING = 54;
/** Turn of the ring for a torque as large as the whole force on the arm [rad]. */
const ROUND = 2.5;

export class PushLayer {
  readonly group = svg("g", { class: "layer-push" });
  readonly #ring = svg("circle", { class: "push-ring", r: RING });
  readonly #arc = svg("path", { class: "push-arc" });
  readonly #shaft = svg("path", { class: "shaft" });
  readonly #head = svg("path", { class: "head" });
  wrench: Triple = [0, 0, 0];
  #waiting = false;
  #again = false;
  #stage: Stage | null = null;

  constructor(readonly context: Context) {
    this.group.append(this.#ring, this.#arc, this.#shaft, this.#head);
  }

  /** Begins with a tenth of all that the robots have, ahead. */
  begin(stage: Stage): void {
    this.#stage = stage;
    if (this.wrench.every((part) => part === 0)) this.wrench = [0.1 * this.#whole, 0, 0];
    this.ask();
  }

  /** Asks who gives how much; one question at a time, the newest next. */
  ask(): void {
    if (this.#waiting) {
      this.#again = true;
      return;
    }
    const { store, talk } = this.context;
    const seen = store.seen.value;
    if (seen === null || seen.mode !== "push") return;
    this.#waiting = true;
    void talk.request({ kind: "forces", doc: seen.doc, speech: seen.scene.speech, wrench: this.wrench }).then((reply) => {
      this.#waiting = false;
      if (store.seen.value?.mode !== "push") return;
      if (reply.kind === "forces") store.setForces(reply);
      else if (reply.kind === "error") this.context.toast(reply.say);
      if (this.#again) {
        this.#again = false;
        this.ask();
      }
    });
  }

  draw(stage: Stage): void {
    this.#stage = stage;
    const on = stage.seen.mode === "push";
    put(this.group, { hidden: !on });
    if (!on) return;
    const { centre } = stage;
    const held = stage.seen.forces?.held ?? true;
    put(this.group, { class: held ? "layer-push" : "layer-push unreached" });
    put(this.#ring, { cx: centre[0], cy: centre[1] });
    const drawn = arrow(centre, this.#tip(), 3.2);
    const still = Math.hypot(this.wrench[0], this.wrench[1]) === 0;
    put(this.#shaft, { d: still ? path([centre, centre]) : drawn.shaft });
    put(this.#head, { d: still ? "" : drawn.head });
    const turn = this.#turn();
    put(this.#arc, { d: turn === 0 ? "" : arcPath(centre, RING, Math.PI / 2, Math.PI / 2 + turn) });
  }

  knobs(): Knob[] {
    const { speech, screen, centre } = this.#stage!;
    const force = Math.hypot(this.wrench[0], this.wrench[1]);
    const tip = this.#tip();
    const way = force === 0 ? 0 : Math.atan2(this.wrench[1], this.wrench[0]);
    const arm = this.#stage!.seen.doc.problem.swarm.characteristic_length;
    const angle = Math.PI / 2 + this.#turn();
    return [
      {
        grip: { kind: "force" }, at: screen.step(tip, way, 11), label: "Wanted force", value: force,
        text: `${speech.force(force)} towards ${speech.bearingOf(way)}`,
      },
      {
        grip: { kind: "torque" }, label: "Wanted turn", value: this.wrench[2] / arm,
        at: [centre[0] + RING * Math.cos(angle), centre[1] - RING * Math.sin(angle)],
        text: `${speech.force(Math.abs(this.wrench[2]) / arm)} on ${speech.length(arm)}, to ${this.wrench[2] >= 0 ? "port" : "starboard"}`,
      },
    ];
  }

  /** Moves the arrow's head to a pixel. */
  pull(to: Pair): void {
    const { screen, centre } = this.#stage!;
    const [right, up] = [to[0] - centre[0], centre[1] - to[1]];
    const length = Math.max(0, Math.hypot(right, up) - 11);
    const way = screen.direction(right, up);
    const force = (length / REACH) * this.#whole;
    this.set([force * Math.cos(way), force * Math.sin(way), this.wrench[2]]);
  }

  /** Moves the ring's knob to a pixel. */
  twist(to: Pair): void {
    const { centre } = this.#stage!;
    const angle = Math.atan2(centre[1] - to[1], to[0] - centre[0]) - Math.PI / 2;
    const folded = Math.atan2(Math.sin(angle), Math.cos(angle));
    const arm = this.#stage!.seen.doc.problem.swarm.characteristic_length;
    this.set([this.wrench[0], this.wrench[1], (Math.abs(folded) < 0.05 ? 0 : folded / ROUND) * this.#whole * arm]);
  }

  /** By keys: force ahead and to port, and turn, in hundredths of all there is. */
  nudge(grip: "force" | "torque", right: number, up: number, by: number): void {
    const step = 0.01 * by * this.#whole;
    if (grip === "torque") {
      const arm = this.#stage!.seen.doc.problem.swarm.characteristic_length;
      this.set([this.wrench[0], this.wrench[1], this.wrench[2] - (right - up) * step * arm]);
      return;
    }
    const way = this.#stage!.screen.direction(right, up);
    this.set([this.wrench[0] + step * Math.cos(way), this.wrench[1] + step * Math.sin(way), this.wrench[2]]);
  }

  set(wrench: Triple): void {
    this.wrench = wrench.map((part) => (Math.abs(part) < 1e-9 * this.#whole ? 0 : part)) as Triple;
    this.ask();
  }

  get #whole(): number {
    return this.#stage!.seen.doc.problem.swarm.robots.reduce((sum, robot) => sum + robot.limit, 0) || 1;
  }

  #tip(): Pair {
    const force = Math.hypot(this.wrench[0], this.wrench[1]);
    const { screen, centre } = this.#stage!;
    return screen.step(centre, Math.atan2(this.wrench[1], this.wrench[0]), (force / this.#whole) * REACH);
  }

  #turn(): number {
    const arm = this.#stage!.seen.doc.problem.swarm.characteristic_length;
    return Math.max(-3, Math.min(3, (ROUND * this.wrench[2]) / (arm * this.#whole)));
  }
}
