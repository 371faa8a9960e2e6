// The immediate plan of the open job: asked for whenever an amount moves, only the newest counts. What was refused is not asked again
// until the job changes.

import { untrack } from "svelte";
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
  #asked: { key: string; charts: string; files: Record<string, string> } | undefined;
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

  /** Plans the job as its tree stands with what was moved; the same question is sent once, whatever its answer. */
  ask(tree: Table, files: Record<string, string>, charts: string[]): void {
    const whole = Object.values(this.moved).reduce<Json>((job, { path, value }) => withValue(job, path, value), tree);
    const key = JSON.stringify(whole);
    const asked = { key, charts: charts.join(), files };
    const last = this.#asked;
    const isSameJob = last !== undefined && last.key === key && last.files === files;
    this.#asked = asked;
    // Of a refused job no other charts are asked for either. The failure is not read for the effect that asks.
    const isRefused = untrack(() => this.failure?.kind === "refused" && !this.#latest.isBusy);
    if (isSameJob && (last.charts === asked.charts || isRefused)) return;
    // An effect that asks must not run again when the answer comes.
    untrack(() => (this.isBusy = true));
    this.#latest.ask({ job: { text: key, files }, charts });
  }

  /** Asks the last question again, after a failure that was not of the job. */
  retry(): void {
    const last = this.#asked;
    if (!last) return;
    this.isBusy = true;
    const charts = last.charts === "" ? [] : last.charts.split(",");
    this.#latest.ask({ job: { text: last.key, files: last.files }, charts });
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
    this.#asked = undefined;
  }
}

export const previews = new PreviewStore();
