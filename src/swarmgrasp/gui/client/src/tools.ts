/* The plan's own buttons: add a robot, edit zones and outline, ask for forces. */

import type { Context, Mode, Seen, View } from "./context";
import { el, icon, put, show, write } from "./dom";
import type { Plan } from "./plan/plan";
import { newRobot, withRobots } from "./plan/adding";
import { withNew, type Drawn } from "./plan/drawing";
import type { Grip } from "./plan/handles";
import { withoutCorner } from "./plan/outline";

function button(text: string, run: () => void, sign?: string): HTMLButtonElement {
  const made = el("button", { type: "button", class: "control tool" }, sign === undefined ? null : icon(sign), el("span", {}, text));
  made.addEventListener("click", run);
  return made;
}

export class Tools implements View {
  readonly #add: HTMLButtonElement;
  readonly #zones: HTMLButtonElement;
  readonly #force: HTMLButtonElement;
  readonly #outline: HTMLButtonElement;
  readonly #area: HTMLButtonElement;
  readonly #edit = el("div", { class: "inspect edit-bar", role: "group", "aria-label": "Zones and outline", hidden: true });
  readonly #hint = el("span", { class: "inspect-where" });

  constructor(readonly plan: Plan, readonly context: Context) {
    this.#add = button("Robot", () => this.add(), "plus");
    this.#zones = button("Zones", () => this.toggle("edit"));
    this.#force = button("Push forces", () => this.toggle("push"));
    this.#outline = button("Outline", () => this.toggle("outline"));
    this.#area = button("Area", () => this.#addNew("area"), "plus");
    this.#edit.append(
      this.#hint, button("Zone", () => this.#addNew("zone"), "plus"), button("No-go", () => this.#addNew("no-go"), "plus"), this.#area,
      this.#outline, button("Done", () => context.store.setMode("move")),
    );
    plan.card.append(el("div", { class: "tools", role: "toolbar", "aria-label": "Tools of the plan" }, this.#add, this.#zones, this.#force), this.#edit);
    plan.svg.addEventListener("keydown", (event) => {
      if (event.key !== "Delete" && event.key !== "Backspace") return;
      const knob = (event.target as Element).closest<SVGElement>("[data-knob]");
      if (knob !== null) this.#remove(plan.handles.knobs[Number(knob.dataset.knob)]!.grip);
    });
  }

  draw(seen: Seen): void {
    write(this.#add.lastElementChild!, this.context.speech.value.Robot);
    put(this.#add, { "aria-label": `Add a ${this.context.speech.value.robot}` });
    const editing = seen.mode === "edit" || seen.mode === "outline";
    put(this.#zones, { "aria-pressed": String(editing) });
    put(this.#force, { "aria-pressed": String(seen.mode === "push") });
    put(this.#outline, { "aria-pressed": String(seen.mode === "outline") });
    show(this.#edit, editing);
    const { zones, newcomer: { mounted } } = seen.doc.problem;
    show(this.#area, mounted);
    const draw = mounted ? "Draw an area inside" : "Draw along the outline, with Shift a no-go";
    write(this.#hint, seen.mode === "outline" ? "Drag corners; Delete takes one away"
      : `${draw}; ${zones === null ? "everywhere is allowed" : "Delete takes one away"}`);
  }

  add(): void {
    const { stage } = this.plan;
    if (stage === null) return;
    const robot = newRobot(stage.shape, this.context.store.seen.value!.doc, this.context.speech.value.Robot);
    this.context.store.edit((doc) => withRobots(doc, [robot]));
    this.context.store.setMode("move");
    this.context.store.choose(robot.name);
    this.plan.focus(robot.name);
  }

  /** Into a mode, or out of it. */
  toggle(mode: Mode): void {
    const { store } = this.context;
    const now = store.seen.value?.mode;
    store.choose(null);
    store.setMode(now === mode ? (mode === "outline" ? "edit" : "move") : mode);
    if (store.seen.value?.mode === "push" && this.plan.stage !== null) this.plan.push.begin(this.plan.stage);
  }

  #addNew(kind: Drawn): void {
    const { stage } = this.plan;
    if (stage === null) return;
    this.context.store.editProblem((problem) => withNew(problem, stage.shape, stage.speech, kind));
    this.context.store.setMode("edit");
  }

  #remove(grip: Grip): void {
    const { store } = this.context;
    if (grip.kind === "zone" || grip.kind === "area") {
      store.editProblem((problem) => ({ ...problem, zones: problem.zones!.filter((_, i) => i !== grip.index) }));
    } else if (grip.kind === "no-go") {
      store.editProblem((problem) => ({ ...problem, no_go: problem.no_go.filter((_, i) => i !== grip.index) }));
    } else if (grip.kind === "vertex") store.editProblem((problem) => withoutCorner(problem, grip.corner));
  }
}
