/* Over everything while the server does not answer: what is kept, and how it goes on. */

import type { Context, Seen, View } from "./context";
import { el, show, write } from "./dom";

export class Banner implements View {
  readonly #words = el("span");

  constructor(readonly node: HTMLElement, readonly context: Context) {
    const again = el("button", { type: "button", class: "control" }, "Try now");
    again.addEventListener("click", () => context.talk.wire.retry());
    node.append(this.#words, again);
    // Before the first scene nothing is drawn: the banner listens for itself.
    context.talk.wire.refusal.listen(() => this.#say());
    context.talk.connected.listen(() => this.#say());
  }

  draw(_seen: Seen): void {
    this.#say();
  }

  #say(): void {
    const { talk, store } = this.context;
    const { refusal } = talk.wire;
    const down = !talk.connected.value && (store.seen.value !== null || refusal.value !== null);
    show(this.node, down);
    if (!down) return;
    const kept = store.seen.value === null ? "" : " Everything here is kept.";
    write(this.#words, refusal.value === null
      ? `The server does not answer.${kept} The page goes on as soon as it is back.`
      : `The server does not know this window's key; open the link that it printed.${kept}`);
  }
}
