/* Keys that are heard anywhere on the page; those of a robot are heard on it. */

import type { Bar } from "./bar";
import type { Context } from "./context";
import type { Inspector } from "./inspect";
import type { Menu } from "./menu";
import type { Plan } from "./plan/plan";
import type { Sheet } from "./sheet";
import type { Store } from "./state";
import type { Tools } from "./tools";

export interface Parts {
  readonly bar: Bar;
  readonly inspector: Inspector;
  readonly menu: Menu;
  readonly plan: Plan;
  readonly sheet: Sheet;
  readonly tools: Tools;
  readonly toggleText: () => void;
  readonly textIsOpen: () => boolean;
  readonly showKeys: () => void;
}

const LET_GO = ["pointerup", "pointercancel"] as const;

/** Hears keys on the widget's root. */
export function hearKeys(context: Context, parts: Parts): void {
  const { root, store } = context;
  if (root.tabIndex < 0) root.tabIndex = -1;
  const target = root.ownerDocument.body.contains(root) && root.dataset.home === "page" ? root.ownerDocument : root;
  target.addEventListener("keydown", (event) => {
    const key = event as KeyboardEvent;
    if (key.defaultPrevented || typing(key)) return;
    const run = key.ctrlKey || key.metaKey ? withControl(key, context, parts) : key.altKey ? null : plainly(key, context, parts);
    if (run === null) return;
    key.preventDefault();
    run();
  });
  settleAtRest(target, root.ownerDocument, store);
}

/** A gesture of keys rests when a key is let go, but for one beside a pointer that holds something. */
function settleAtRest(target: Document | HTMLElement, page: Document, store: Store): void {
  let held = false;
  const rest = (): void => {
    if (store.seen.value?.moving === true && !held) store.settle();
  };
  const letGo = (): void => {
    held = false;
    for (const kind of LET_GO) page.removeEventListener(kind, letGo);
    rest();
  };
  target.addEventListener("keyup", rest);
  target.addEventListener("pointerdown", () => {
    held = true;
    for (const kind of LET_GO) page.addEventListener(kind, letGo);
  }, { capture: true });
}

function typing(event: KeyboardEvent): boolean {
  const target = event.composedPath()[0];
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && target.type !== "file");
}

function withControl(event: KeyboardEvent, { store, root }: Context, { menu }: Parts): (() => void) | null {
  if (root.dataset.home !== "page" && /^[so]$/i.test(event.key)) return null; // the notebook's own
  switch (event.key.toLowerCase()) {
    case "z": return () => (event.shiftKey ? store.redo() : store.undo());
    case "y": return () => store.redo();
    case "s": return () => void menu.save();
    case "o": return () => menu.open();
    default: return null;
  }
}

function plainly(event: KeyboardEvent, context: Context, parts: Parts): (() => void) | null {
  const { store } = context;
  const { inspector, tools, bar, plan } = parts;
  const seen = store.seen.value;
  if (seen === null) return null;
  if (/^[0-3]$/.test(event.key)) {
    const losing = Number(event.key);
    return () => store.editProblem((problem) => ({ ...problem, criterion: { ...problem.criterion, losing } }));
  }
  const onButton = (event.composedPath()[0] as Element).closest?.("button") !== null;
  switch (event.key) {
    case ",": case ".": return () => walk(context, plan, event.key === "." ? 1 : -1);
    case "+": case "=": return () => inspector.strengthen(1);
    case "-": case "−": return () => inspector.strengthen(-1);
    case "f": return () => inspector.flip();
    case "a": return () => tools.add();
    case "d": return () => inspector.duplicate();
    case "Delete": case "Backspace": return () => inspector.remove();
    case "m": return seen.chosen === null ? null : () => inspector.more.toggle();
    case "n": return () => chooseNewcomer(context);
    case "Enter": return seen.chosen === seen.doc.problem.newcomer.name && !onButton ? () => inspector.keep() : null;
    case "z": return () => tools.toggle(seen.mode === "edit" ? "outline" : seen.mode === "outline" ? "outline" : "edit");
    case "h": return () => tools.toggle("push");
    case "w": return () => bar.toggleWind();
    case "t": return parts.toggleText;
    case "?": return parts.showKeys;
    case "Escape": return () => letGo(context, parts);
    default: return null;
  }
}

/** From what is nearest the hand to what is farthest: gesture, sheet, text, mode, choice. */
function letGo({ store }: Context, { plan, sheet, textIsOpen, toggleText }: Parts): void {
  const seen = store.seen.value!;
  if (plan.hands.busy) plan.hands.letGo();
  else if (sheet.isOpen) sheet.close();
  else if (seen.mode !== "move") store.setMode(seen.mode === "outline" ? "edit" : "move");
  else if (seen.chosen !== null) store.choose(null);
  else if (textIsOpen()) toggleText();
}

function walk(context: Context, plan: Plan, by: number): void {
  const { store } = context;
  const seen = store.seen.value!;
  const names = seen.doc.problem.swarm.robots.map(({ name }) => name);
  if (names.length === 0) return;
  const now = seen.chosen === null ? -1 : names.indexOf(seen.chosen);
  const next = names[now < 0 ? (by > 0 ? 0 : names.length - 1) : (now + by + names.length) % names.length]!;
  store.setMode("move");
  store.choose(next);
  plan.focus(next);
}

function chooseNewcomer({ store }: Context): void {
  const seen = store.seen.value!;
  if (!seen.doc.newcomer) store.edit((doc) => ({ ...doc, newcomer: true }));
  store.setMode("move");
  store.choose(seen.doc.problem.newcomer.name);
}
