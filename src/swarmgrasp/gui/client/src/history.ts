/* Undo without end: a gesture is one step, however many moves it had. */

export class History<T> {
  #now: T;
  #base: { readonly value: T } | null = null;
  readonly #past: T[] = [];
  #future: T[] = [];

  constructor(first: T) {
    this.#now = first;
  }

  get now(): T {
    return this.#now;
  }

  get canUndo(): boolean {
    return this.#past.length > 0 || (this.#base !== null && this.#base.value !== this.#now);
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** One step. */
  set(value: T): void {
    this.settle();
    if (value === this.#now) return;
    this.#past.push(this.#now);
    this.#future = [];
    this.#now = value;
  }

  /** A move of a gesture, which is one step when it settles. */
  move(value: T): void {
    this.#base ??= { value: this.#now };
    this.#now = value;
  }

  /** Ends a gesture. */
  settle(): void {
    const base = this.#base;
    this.#base = null;
    if (base === null || base.value === this.#now) return;
    this.#past.push(base.value);
    this.#future = [];
  }

  /** Leaves a gesture as if it had not been. */
  abandon(): void {
    if (this.#base !== null) this.#now = this.#base.value;
    this.#base = null;
  }

  undo(): boolean {
    this.settle();
    const before = this.#past.pop();
    if (before === undefined) return false;
    this.#future.push(this.#now);
    this.#now = before;
    return true;
  }

  redo(): boolean {
    this.settle();
    const after = this.#future.pop();
    if (after === undefined) return false;
    this.#past.push(this.#now);
    this.#now = after;
    return true;
  }
}
