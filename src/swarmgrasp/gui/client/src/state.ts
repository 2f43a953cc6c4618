/* The page's state: a document with its history, and what the server said of it. */

import type { Hovered, Mode, Seen } from "./context";
import { History } from "./history";
import type { AnyPart, Doc, Fault, Forces, Incoming, NewcomerData, ProblemData, RobotData, Scene } from "./messages";
import { Signal } from "./signal";

/** One step of the history: a document, and the text and terms that it was read from. */
export interface Draft {
  readonly scene: Scene;
  readonly doc: Doc;
}

export class Store {
  readonly seen: Signal<Seen | null> = new Signal<Seen | null>(null);
  readonly hover = new Signal<Hovered | null>(null);
  /** Set once: a document to be asked about. */
  ask: (draft: Draft, moving: boolean) => number = () => 0;
  #history: History<Draft> | null = null;
  #origin: Scene | null = null;
  #moving = false;
  /** Parts of older asks belong to another scene. */
  #oldest = 0;
  /** The least number that an answer about the document as it is now may bear. */
  #newest = 0;

  get canUndo(): boolean {
    return this.#history?.canUndo ?? false;
  }

  get canRedo(): boolean {
    return this.#history?.canRedo ?? false;
  }

  /** Whether the answer that is there is about the document as it is now. */
  get isAnswered(): boolean {
    const { parts: { answer }, refused } = this.seen.value ?? { parts: {}, refused: [] };
    return answer !== undefined && answer.n >= this.#newest && refused.length === 0;
  }

  get draft(): Draft | null {
    return this.#history?.now ?? null;
  }

  /** The scene as it was opened: what it is to start over. */
  get origin(): Scene | null {
    return this.#origin;
  }

  /** A new scene: its history begins here, and goes on with the changes that were kept. */
  open(origin: Scene, kept: Draft = { scene: origin, doc: origin.doc }): void {
    const { scene, doc } = kept;
    this.#origin = origin;
    this.#history = new History<Draft>({ scene: origin, doc: origin.doc });
    if (doc !== origin.doc) this.#history.set({ scene, doc });
    this.#moving = false;
    this.seen.set({
      scene, doc, parts: {}, empty: {}, refused: [], moving: false, chosen: null, mode: "move",
      forces: null,
      connected: this.seen.value?.connected ?? true,
    });
    this.#oldest = this.ask({ scene, doc }, false);
    this.#newest = this.#oldest;
  }

  /** The same scene read again from a text; typing is a gesture, which ends when it rests. */
  read(scene: Scene, typing: boolean): void {
    const draft = { scene, doc: scene.doc };
    if (typing) this.#history?.move(draft);
    else this.#history?.set(draft);
    this.#asked(false);
  }

  /** Back to the scene as it was opened: one step. */
  startOver(): void {
    if (this.#origin !== null) this.read(this.#origin, false);
  }

  /** One step; with `moving` a part of a gesture, which ends with `settle`. */
  edit(change: (doc: Doc) => Doc, moving = false): void {
    const history = this.#history;
    if (history === null) return;
    const doc = change(history.now.doc);
    if (doc === history.now.doc) return;
    if (moving) history.move({ ...history.now, doc });
    else history.set({ ...history.now, doc });
    this.#asked(moving);
  }

  editProblem(change: (problem: ProblemData) => ProblemData, moving = false): void {
    this.edit((doc) => {
      const problem = change(doc.problem);
      return problem === doc.problem ? doc : { ...doc, problem };
    }, moving);
  }

  editRobot(name: string, change: (robot: RobotData) => RobotData, moving = false): void {
    this.editProblem((problem) => {
      const robots = problem.swarm.robots.map((robot) => (robot.name === name ? change(robot) : robot));
      return { ...problem, swarm: { ...problem.swarm, robots } };
    }, moving);
  }

  editNewcomer(change: (newcomer: NewcomerData) => NewcomerData, moving = false): void {
    this.editProblem((problem) => ({ ...problem, newcomer: change(problem.newcomer) }), moving);
  }

  /** The hand rests: a gesture is one step. */
  settle(): void {
    this.#history?.settle();
    if (this.#moving) this.#asked(false);
  }

  /** A gesture is left as if it had not been. */
  abandon(): void {
    this.#history?.abandon();
    if (this.#moving) this.#asked(false);
  }

  undo(): void {
    if (this.#history?.undo() === true) this.#asked(false);
  }

  redo(): void {
    if (this.#history?.redo() === true) this.#asked(false);
  }

  choose(name: string | null): void {
    this.#see({ chosen: name });
  }

  setMode(mode: Mode): void {
    this.#see({ mode, forces: null });
  }

  setForces(forces: Forces | null): void {
    this.#see({ forces });
  }

  setConnected(connected: boolean): void {
    this.#see({ connected });
  }

  /** What the server said of a document. */
  take(message: Incoming): void {
    const seen = this.seen.value;
    if (seen === null || !("n" in message) || (message.n as number) < this.#oldest) return;
    if (message.kind === "part") this.#part(seen, message);
    else if (message.kind === "empty") {
      if (seen.empty[message.of] === message.why && seen.parts[message.of] === undefined) return;
      const { [message.of]: _, ...parts } = seen.parts;
      this.#see({ parts, empty: { ...seen.empty, [message.of]: message.why } });
    } else if (message.kind === "refused") this.#see({ refused: message.faults });
    else if (message.kind === "error") this.#see({ refused: [faultOf(message.say)] });
  }

  #part(seen: Seen, part: AnyPart): void {
    const { [part.name]: _, ...empty } = seen.empty;
    const parts = { ...seen.parts, [part.name]: part };
    if (part.name === "answer") {
      delete parts.proof;
      this.#see({ parts, empty, refused: [] });
    } else this.#see({ parts, empty });
  }

  #asked(moving: boolean): void {
    const draft = this.#history?.now;
    if (draft === undefined) return;
    this.#moving = moving;
    const known = draft.doc.problem.swarm.robots.some((robot) => robot.name === this.seen.value?.chosen)
      || draft.doc.problem.newcomer.name === this.seen.value?.chosen;
    this.#see({ ...draft, moving, ...(known ? {} : { chosen: null }) });
    this.#newest = this.ask(draft, moving);
  }

  #see(change: Partial<Seen>): void {
    const seen = this.seen.value;
    if (seen !== null) this.seen.set({ ...seen, ...change });
  }
}

function faultOf(sentence: string): Fault {
  return { line: null, column: null, path: "", sentence };
}
