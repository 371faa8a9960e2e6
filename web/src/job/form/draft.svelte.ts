// What is being typed into a field, until the job has it: sent after a pause, and dropped when the job changes by itself, as by undo.

import type { Json } from "../../lib/path";

export class Draft {
  text = $state<string>();
  #sent: Json[] = [];
  #noted: Json | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** `send` hands over what was typed and tells the value that the job will have; undefined where there is nothing to send. */
  constructor(
    readonly send: (text: string) => Json | undefined,
    readonly afterMs: number,
  ) {}

  type(text: string): void {
    this.text = text;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.flush(), this.afterMs);
  }

  /** Sends what was typed at once. */
  flush(): void {
    clearTimeout(this.#timer);
    if (this.text === undefined) return;
    const value = this.send(this.text);
    if (value !== undefined) this.#sent.push(value);
  }

  /** Sends what was typed; the field shows the value of the job again. */
  leave(): void {
    this.flush();
    this.text = undefined;
  }

  /** The job has this value now: what was typed stays if it led there, otherwise the job changed by itself. */
  note(value: Json | undefined): void {
    if (value === this.#noted) return;
    this.#noted = value;
    const at = this.#sent.indexOf(value ?? null);
    if (at >= 0) {
      this.#sent.splice(0, at + 1);
      return;
    }
    clearTimeout(this.#timer);
    this.#sent = [];
    this.text = undefined;
  }
}
