/* What was changed in each scene, kept by the browser until it is given up. */

import type { Doc } from "./messages";

const PREFIX = "swarmgrasp:";

export interface Saved {
  /** The scene's text as it was opened: changes of another text are not offered. */
  readonly of: string;
  /** The text that the document was read from: another one where somebody typed. */
  readonly text: string;
  readonly doc: Doc;
}

export class Autosave {
  /** Scenes whose changes this window wrote: it removes no others. */
  readonly #own = new Set<string>();

  constructor(readonly storage: Storage | null) {}

  /** The changes that were kept, if the scene's text is still the same. */
  kept(scene: string, text: string): Saved | null {
    const found = this.storage?.getItem(PREFIX + scene);
    if (found === null || found === undefined) return null;
    try {
      const saved = JSON.parse(found) as Saved;
      return saved.of === text ? saved : null;
    } catch {
      return null;
    }
  }

  /** Keeps changes; tells whether the browser had room. */
  keep(scene: string, saved: Saved): boolean {
    try {
      this.storage?.setItem(PREFIX + scene, JSON.stringify(saved));
      this.#own.add(scene);
      return true;
    } catch {
      return false;
    }
  }

  /** Forgets what this window kept, or what it was asked to forget. */
  forget(scene: string, asked = false): void {
    if (asked || this.#own.has(scene)) this.storage?.removeItem(PREFIX + scene);
    this.#own.delete(scene);
  }
}
