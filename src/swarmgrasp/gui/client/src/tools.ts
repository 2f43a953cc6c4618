/* The plan's own buttons: add a robot, edit zones and outline, ask for forces. */

import type { Context, Mode, Seen, View } from "./context";
import { el, icon, put, show, write } from "./dom";
import type { StretchData, ZoneData } from "./messages";
import type { Plan } from "./plan/plan";
import { roomiest, withRobots } from "./plan/moves";
import type { Grip } from "./plan/handles";
import { withoutCorner } from "./plan/outline";

/** Share of the outline that a new zone takes. */
const NEW_ZONE = 0.08;

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
  readonly #edit = el("div", { class: "inspect edit-bar", role: "group", "aria-label": "Zones and outline", hidden: true });
  readonly #hint = el("span", { class: "inspect-where" });

  constructor(readonly plan: Plan, readonly context: Context) {
    this.#add = button("Robot", () => this.add(), "plus");
    this.#zones = button("Zones", () => this.toggle("edit"));
    this.#force = button("Push forces", () => this.toggle("push"));
    this.#outline = button("Outline", () => this.toggle("outline"));
    this.#edit.append(
      this.#hint, button("Zone", () => this.#addStretch("zone"), "plus"), button("No-go", () => this.#addStretch("no-go"), "plus"),
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
    const everywhere = seen.doc.problem.zones === null;
    write(this.#hint, seen.mode === "outline" ? "Drag corners; Delete takes one away"
      : everywhere ? "All round is allowed" : "Drag the ends; Delete takes one away");
  }

  add(): void {
    const { stage } = this.plan;
    if (stage === null) return;
    const robot = roomiest(stage.shape, this.context.store.seen.value!.doc, this.context.speech.value.Robot);
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

  #addStretch(kind: "zone" | "no-go"): void {
    const { stage } = this.plan;
    if (stage === null) return;
    const { shape } = stage;
    const { doc } = this.context.store.seen.value!;
    const middle = shape.nearest(roomiest(shape, doc, "x").contact).along;
    const half = (NEW_ZONE * shape.perimeter) / 2;
    this.context.store.editProblem((problem) => {
      const count = (kind === "zone" ? problem.zones?.length ?? 0 : problem.no_go.length) + 1;
      const stretch: StretchData = { start: shape.wrapped(middle - half), end: shape.wrapped(middle + half), name: `${kind} ${count}` };
      if (kind === "no-go") return { ...problem, no_go: [...problem.no_go, stretch] };
      const zone: ZoneData = { stretch, attachment: null, half_angle: null, directions: null, area: null, name: stretch.name };
      return { ...problem, zones: [...(problem.zones ?? []), zone] };
    });
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
