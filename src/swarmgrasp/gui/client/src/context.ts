/* What every view is given: nothing of the page is kept outside it. */

import type { AnyPart, Doc, Fault, Forces, PartName, RobotData, Scene } from "./messages";
import type { Signal } from "./signal";
import type { Speech } from "./speech";
import type { Store } from "./state";
import type { Talk } from "./talk";

/** The newest of each part; `answer` and the others may belong to different asks. */
export type Parts = { [name in PartName]?: Extract<AnyPart, { name: name }> };

export type Mode = "move" | "edit" | "outline" | "push";

/** What is to be drawn: all that a view may know. */
export interface Seen {
  readonly scene: Scene;
  readonly doc: Doc;
  readonly parts: Parts;
  /** Why a part has nothing to show. */
  readonly empty: { readonly [name in PartName]?: string };
  /** Of the document that is refused; the parts are then of the last that was not. */
  readonly refused: readonly Fault[];
  /** Whether a hand is moving something. */
  readonly moving: boolean;
  /** The robot that is chosen; of the newcomer its own name. */
  readonly chosen: string | null;
  readonly mode: Mode;
  /** How hard each pushes for the wanted wrench; null outside mode "push". */
  readonly forces: Forces | null;
  readonly connected: boolean;
}

export type Hovered =
  | { readonly kind: "robot"; readonly name: string }
  | { readonly kind: "zone"; readonly name: string }
  /** A cell of the landscape: the newcomer as it would stand there, and its value. */
  | { readonly kind: "place"; readonly robot: RobotData; readonly value: number | null };

export interface Context {
  /** The element that holds the whole widget: look up and listen here, never in the document. */
  readonly root: HTMLElement;
  readonly store: Store;
  readonly talk: Talk;
  readonly hover: Signal<Hovered | null>;
  /** Numbers as the scene's people say them; another object for each scene. */
  readonly speech: Signal<Speech>;
  /** Whether motion is wanted reduced. */
  readonly calm: () => boolean;
  /** A sentence for those who hear the page. */
  readonly say: (sentence: string) => void;
  /** A sentence that goes by itself, with at most one button. */
  readonly toast: (sentence: string, action?: { word: string; run: () => void }) => void;
}

export interface View {
  draw(seen: Seen): void;
}
