// Short notices at the lower edge: what was done, or what failed on the way.

import { asFailure } from "../api/failure";
import { i18n } from "../texts/i18n.svelte";

export interface Notice {
  id: number;
  text: string;
  isBad: boolean;
}

class Notices {
  list = $state<Notice[]>([]);
  #next = 1;

  say(text: string, isBad = false): void {
    const id = this.#next++;
    this.list = [...this.list, { id, text, isBad }].slice(-4);
    setTimeout(() => this.drop(id), isBad ? 12000 : 4000);
  }

  /** A failed request in one line with its way out. */
  fail(error: unknown): void {
    const failure = asFailure(error);
    const way = failure.findings[0]?.way_out;
    const why = failure.findings[0]?.message;
    this.say([i18n.t.failure[failure.kind], why, way].filter(Boolean).join(" "), true);
  }

  drop(id: number): void {
    this.list = this.list.filter((notice) => notice.id !== id);
  }
}

export const notices = new Notices();
