/* Asking: one question in flight and one waiting; what was asked when the line fell is asked again. */

import { decoded, encoded } from "./frames";
import { PROTOCOL, type Doc, type Incoming, type Live, type Outgoing, type SpeechData, type Welcome } from "./messages";
import { Signal } from "./signal";
import type { Wire } from "./wire";

type Asked = Extract<Outgoing, { n: number }>;
type WithoutNumber<M> = M extends { n: number } ? Omit<M, "n"> : never;
/** What can be asked once and answered once. */
export type Request = WithoutNumber<Exclude<Asked, { kind: "ask" | "cancel" }>>;

interface Waiting {
  message: Asked;
  answered: (reply: Incoming) => void;
}

export class Talk {
  readonly connected = new Signal(false);
  readonly welcome = new Signal<Welcome | null>(null);
  /** The newest of robots that are watched. */
  readonly live = new Signal<Live | null>(null);
  /** Set once: everything that is not the answer to a request. */
  hear: (message: Incoming) => void = () => undefined;
  /** Set once: a request is sent, or its answer was given. */
  exchanged: () => void = () => undefined;
  readonly #requests = new Map<number, Waiting>();
  readonly #last = new Map<Request["kind"], Promise<unknown>>();
  #n = 0;
  #flying: Extract<Outgoing, { kind: "ask" }> | null = null;
  #next: { doc: Doc; speech: SpeechData; moving: boolean } | null = null;

  constructor(readonly wire: Wire, readonly key: () => string) {
    wire.hear = (data) => this.#take(decoded(data));
    wire.up.listen((up) => this.#lineIs(up));
    if (wire.up.value) this.#lineIs(true);
  }

  /** Whether the newest question is answered. */
  get idle(): boolean {
    return this.#flying === null && this.#next === null;
  }

  /** Whether all requests are answered. */
  get replied(): boolean {
    return this.#requests.size === 0;
  }

  /**
   * Asks about a document; a newer one takes the place of one that has not been sent yet. Returns
   * the least number that its answer may bear.
   */
  ask(doc: Doc, speech: SpeechData, moving: boolean): number {
    const least = this.#n + 1;
    this.#next = { doc, speech, moving };
    this.#sendNext();
    return least;
  }

  /** Sends what has one answer; of each kind one at a time, since the server answers the newest. */
  request(request: Request): Promise<Incoming> {
    const before = this.#last.get(request.kind) ?? Promise.resolve();
    const reply = before.then(() => this.#exchange(request));
    this.#last.set(request.kind, reply);
    return reply;
  }

  #exchange(request: Request): Promise<Incoming> {
    const message = { ...request, n: ++this.#n } as Asked;
    return new Promise((answered) => {
      this.#requests.set(message.n, { message, answered });
      this.exchanged();
      if (this.connected.value) this.#send(message);
    });
  }

  /** Sends what has no answer of its own, and what a line that fell must not say twice. */
  tell(request: Request): void {
    if (this.connected.value) this.#send({ ...request, n: ++this.#n } as Asked);
  }

  #sendNext(): void {
    if (this.#next === null || this.#flying !== null || !this.connected.value) return;
    this.#flying = { kind: "ask", n: ++this.#n, ...this.#next };
    this.#next = null;
    this.#send(this.#flying);
  }

  #send(message: Outgoing): void {
    const data = encoded(message);
    const limit = this.welcome.value?.limits.message ?? Infinity;
    const size = typeof data === "string" ? new TextEncoder().encode(data).length : data.byteLength;
    if (size <= limit) {
      this.wire.send(data);
      return;
    }
    const n = "n" in message ? message.n : 0;
    const say = `This is too large to send: ${size} bytes; at most ${limit}.`;
    queueMicrotask(() => this.#take({ kind: "error", n, say }));
  }

  #lineIs(up: boolean): void {
    if (up) this.wire.send(encoded({ kind: "hello", key: this.key(), protocol: PROTOCOL }));
    else this.connected.set(false);
  }

  #take(message: Incoming): void {
    if (message.kind === "welcome") {
      this.wire.refusal.set(null);
      this.welcome.set(message);
      this.connected.set(true);
      this.hear(message);
      for (const { message: again } of this.#requests.values()) this.#send(again);
      if (this.#flying !== null) this.#send(this.#flying);
      this.#sendNext();
      return;
    }
    if (message.kind === "live") {
      this.live.set(message);
      return;
    }
    const n = "n" in message ? (message.n as number | null) ?? 0 : 0;
    const waiting = this.#requests.get(n);
    if (waiting !== undefined) {
      this.#requests.delete(n);
      waiting.answered(message);
      queueMicrotask(this.exchanged);
      return;
    }
    const answers = message.kind === "part" ? message.name === "answer" : message.kind !== "empty";
    const landed = answers && this.#flying?.n === n;
    if (landed) this.#flying = null;
    this.hear(message);
    if (landed) this.#sendNext();
  }
}
