// Requests of which only the newest counts: one is under way, one may wait, older ones are dropped. A request that has missed its
// time budget is cancelled as soon as a newer one waits, so that dragging shows every answer that comes in time and never a stale end.

export interface LatestOptions<Input, Output> {
  run: (input: Input, signal: AbortSignal) => Promise<Output>;
  done: (output: Output, input: Input) => void;
  failed: (error: unknown, input: Input) => void;
  budgetMs?: number;
}

export class Latest<Input, Output> {
  #waiting: { input: Input } | undefined;
  #abort: AbortController | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #startedAt = 0;
  readonly #options: LatestOptions<Input, Output>;

  constructor(options: LatestOptions<Input, Output>) {
    this.#options = options;
  }

  get isBusy(): boolean {
    return this.#abort !== undefined;
  }

  /** Asks for `input`, in place of whatever waits. */
  ask(input: Input): void {
    this.#waiting = { input };
    if (!this.#abort) {
      void this.#next();
      return;
    }
    clearTimeout(this.#timer);
    const left = (this.#options.budgetMs ?? 250) - (performance.now() - this.#startedAt);
    this.#timer = setTimeout(() => this.#waiting && this.#abort?.abort(), Math.max(0, left));
  }

  /** Drops what waits and what is under way. */
  stop(): void {
    this.#waiting = undefined;
    clearTimeout(this.#timer);
    this.#abort?.abort();
  }

  async #next(): Promise<void> {
    while (this.#waiting) {
      const { input } = this.#waiting;
      this.#waiting = undefined;
      const abort = new AbortController();
      this.#abort = abort;
      this.#startedAt = performance.now();
      try {
        const output = await this.#options.run(input, abort.signal);
        if (!abort.signal.aborted) this.#options.done(output, input);
      } catch (error) {
        if (!abort.signal.aborted) this.#options.failed(error, input);
      }
      clearTimeout(this.#timer);
    }
    this.#abort = undefined;
  }
}
