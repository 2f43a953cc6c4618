/* The two-way line to whoever answers: a socket here, the comm of a notebook there. */

import { Signal } from "./signal";

export interface Wire {
  readonly up: Signal<boolean>;
  /** Why the other side will not have us. */
  readonly refusal: Signal<string | null>;
  send(data: string | ArrayBuffer): void;
  /** Set once, by who talks over it. */
  hear: (data: string | ArrayBuffer) => void;
  /** Tries again without waiting. */
  retry(): void;
  close(): void;
}

const FIRST_WAIT = 250;
const LONGEST_WAIT = 4000;

/** A WebSocket that comes back by itself. */
export class SocketWire implements Wire {
  readonly up = new Signal(false);
  readonly refusal = new Signal<string | null>(null);
  hear: (data: string | ArrayBuffer) => void = () => undefined;
  #socket: WebSocket | null = null;
  #wait = FIRST_WAIT;
  #timer = 0;
  #closed = false;

  constructor(readonly url: string) {
    this.#connect();
  }

  send(data: string | ArrayBuffer): void {
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(data);
  }

  close(): void {
    this.#closed = true;
    clearTimeout(this.#timer);
    this.#socket?.close();
  }

  retry(): void {
    if (this.#closed || this.up.value) return;
    clearTimeout(this.#timer);
    this.#wait = FIRST_WAIT;
    this.#connect();
  }

  #connect(): void {
    const socket = new WebSocket(this.url);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    socket.onopen = () => {
      this.#wait = FIRST_WAIT;
      this.up.set(true);
    };
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.hear(event.data);
    socket.onclose = (event) => {
      if (this.#socket !== socket) return;
      this.up.set(false);
      if (event.code >= 4400) this.refusal.set(event.reason);
      if (this.#closed) return;
      this.#timer = window.setTimeout(() => this.#connect(), this.#wait);
      this.#wait = Math.min(2 * this.#wait, LONGEST_WAIT);
    };
  }
}
