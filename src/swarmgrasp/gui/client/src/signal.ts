/* A value that tells who listens when it changes. */

export class Signal<T> {
  #value: T;
  readonly #heard = new Set<(value: T) => void>();

  constructor(value: T) {
    this.#value = value;
  }

  get value(): T {
    return this.#value;
  }

  set(value: T): void {
    if (value === this.#value) return;
    this.#value = value;
    for (const hear of [...this.#heard]) hear(value);
  }

  /** Returns what stops it. */
  listen(hear: (value: T) => void): () => void {
    this.#heard.add(hear);
    return () => this.#heard.delete(hear);
  }
}
