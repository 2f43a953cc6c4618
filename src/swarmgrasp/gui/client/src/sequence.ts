/* Several newcomers, one after the other or together: where those after the first would go. */

import type { Context, Seen } from "./context";
import type { Doc, Sequence } from "./messages";

export class Later {
  /** How many come after the first. */
  count = 0;
  together = false;
  answers: Sequence["answers"] = [];
  /** How good they are, in words. */
  said = "";
  #asked: { doc: Doc; count: number; together: boolean } | null = null;

  constructor(readonly context: Context, readonly changed: () => void) {}

  set(count: number, together: boolean): void {
    this.count = count;
    this.together = together;
    if (count === 0) this.#take([], "");
    this.changed();
    const seen = this.context.store.seen.value;
    if (seen !== null) this.follow(seen);
  }

  #take(answers: Sequence["answers"], said: string): void {
    this.answers = answers;
    this.said = said;
  }

  /** Asks again when the document has come to rest. */
  follow(seen: Seen): void {
    if (this.count === 0 || !seen.doc.newcomer || seen.moving || seen.refused.length > 0) return;
    const { count, together } = this;
    const asked = this.#asked;
    if (asked?.doc === seen.doc && asked.count === count && asked.together === together) return;
    const now = { doc: seen.doc, count, together };
    this.#asked = now;
    void this.context.talk
      .request({ kind: "sequence", doc: seen.doc, speech: seen.scene.speech, robots: count + 1, together })
      .then((reply) => {
        if (this.#asked !== now) return;
        if (reply.kind === "sequence") this.#take(reply.answers, reply.say);
        else {
          this.#take([], "");
          if (reply.kind === "error") this.context.toast(reply.say);
        }
        this.changed();
      });
  }
}
