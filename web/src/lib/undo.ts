// Undo and redo over whole states. Changes of the same origin in quick succession are one step.

export interface UndoState<T> {
  past: T[];
  future: T[];
}

interface Last {
  origin: string;
  at: number;
}

export class Undo<T> {
  past: T[];
  future: T[];
  #last: Last | undefined;

  constructor(
    start: Partial<UndoState<T>> = {},
    readonly most = 200,
    readonly mergeWithinMs = 900,
  ) {
    this.past = start.past ?? [];
    this.future = start.future ?? [];
  }

  /** Keeps the state before a change. A change of the same origin shortly after the last belongs to it. */
  keep(before: T, origin: string, now: number): void {
    const belongs = this.#last?.origin === origin && now - this.#last.at < this.mergeWithinMs;
    this.#last = { origin, at: now };
    this.future = [];
    if (belongs && this.past.length > 0) return;
    this.past = [...this.past, before].slice(-this.most);
  }

  undo(present: T): T | undefined {
    return this.#step(present, "past", "future");
  }

  redo(present: T): T | undefined {
    return this.#step(present, "future", "past");
  }

  #step(present: T, from: "past" | "future", to: "past" | "future"): T | undefined {
    const state = this[from].at(-1);
    if (state === undefined) return undefined;
    this[from] = this[from].slice(0, -1);
    this[to] = [...this[to], present];
    this.#last = undefined;
    return state;
  }
}
