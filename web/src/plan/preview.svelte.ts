// The immediate plan of the open job: asked for whenever an amount moves, only the newest counts.

import * as api from "../api/client";
import { asFailure, type RequestFailure } from "../api/failure";
import type { Job, Preview } from "../api/types";
import { Latest } from "../lib/latest";
import { pathText, withValue, type Json, type Path, type Table } from "../lib/path";

interface Question {
  job: Job;
  charts: string[];
}

class PreviewStore {
  value = $state.raw<Preview>();
  failure = $state.raw<RequestFailure>();
  isBusy = $state(false);
  /** Amounts that were moved and are not in the text yet, by their paths. */
  moved = $state.raw<Record<string, { path: Path; value: Json }>>({});
  /** Time from the question to the answer, in ms. */
  elapsed = $state(0);
  #asked = "";
  #latest = new Latest<Question, { preview: Preview; elapsed: number }>({
    run: async ({ job, charts }, signal) => {
      const begun = performance.now();
      const preview = await api.preview(job, charts, signal);
      return { preview, elapsed: performance.now() - begun };
    },
    done: ({ preview, elapsed }) => {
      this.value = preview;
      this.elapsed = elapsed;
      this.failure = undefined;
      queueMicrotask(() => (this.isBusy = this.#latest.isBusy));
    },
    failed: (error) => {
      this.failure = asFailure(error);
      queueMicrotask(() => (this.isBusy = this.#latest.isBusy));
    },
  });

  /** Plans the job as its tree stands with what was moved. */
  ask(tree: Table, files: Record<string, string>, charts: string[]): void {
    const whole = Object.values(this.moved).reduce<Json>((job, { path, value }) => withValue(job, path, value), tree);
    const text = JSON.stringify(whole);
    const question = `${text}\n${charts.join()}\n${Object.keys(files).join()}`;
    if (question === this.#asked && !this.failure) return;
    this.#asked = question;
    this.isBusy = true;
    this.#latest.ask({ job: { text, files }, charts });
  }

  move(path: Path, value: Json): void {
    this.moved = { ...this.moved, [pathText(path)]: { path, value } };
  }

  /** What was moved stands in the text now, or shall be as there. */
  settle(path: Path): void {
    const { [pathText(path)]: _, ...others } = this.moved;
    this.moved = others;
  }

  /** Another job is open: nothing of the last one counts. */
  forget(): void {
    this.#latest.stop();
    this.isBusy = false;
    this.value = undefined;
    this.failure = undefined;
    this.moved = {};
    this.#asked = "";
  }
}

export const previews = new PreviewStore();
