// Follows a run: its events by a stream, and by asking again where the stream breaks off. What it shows is always the whole run.

import * as api from "../api/client";
import { asFailure, type RequestFailure } from "../api/failure";
import type { Progress, Run, RunState, RunStateAnswer } from "../api/types";
import { runsUnderWay } from "../state/runs.svelte";

const POLL_MS = 2000;
const isUnderWay = (state: RunState): boolean => state === "queued" || state === "running";

export class RunWatch {
  run = $state.raw<Run>();
  failure = $state.raw<RequestFailure>();
  progress = $state.raw<Progress>();
  isPolling = $state(false);
  state = $derived(this.run?.state);
  isUnderWay = $derived(this.run !== undefined && isUnderWay(this.run.state));
  #stream: EventSource | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #isStopped = false;

  constructor(readonly id: string) {
    void this.load();
  }

  async load(): Promise<void> {
    try {
      const run = await api.run(this.id);
      if (this.#isStopped) return;
      this.run = run;
      this.progress = run.progress ?? undefined;
      this.failure = undefined;
      if (!isUnderWay(run.state)) {
        this.#end();
        void runsUnderWay.refresh();
      } else if (this.isPolling) this.#pollLater();
      else this.#listen();
    } catch (error) {
      if (this.#isStopped) return;
      this.failure = asFailure(error);
      if (this.isPolling) this.#pollLater();
    }
  }

  async cancel(): Promise<void> {
    try {
      const { state } = await api.cancelRun(this.id);
      if (this.run) this.run = { ...this.run, state };
      await this.load();
    } catch (error) {
      this.failure = asFailure(error);
    }
  }

  #listen(): void {
    if (this.#stream) return;
    const stream = new EventSource(api.eventsAddress(this.id));
    this.#stream = stream;
    stream.addEventListener("progress", (event) => {
      this.progress = JSON.parse((event as MessageEvent<string>).data) as Progress;
      if (this.run?.state === "queued") this.run = { ...this.run, state: "running" };
    });
    stream.addEventListener("state", (event) => {
      const { state } = JSON.parse((event as MessageEvent<string>).data) as RunStateAnswer;
      if (!this.run) return;
      if (isUnderWay(state)) this.run = { ...this.run, state };
      else this.#finish();
    });
    // A stream that ends is either the end of the run or a broken line: the run itself tells which.
    stream.onerror = () => {
      this.#closeStream();
      this.isPolling = true;
      void this.load();
    };
  }

  #finish(): void {
    this.#closeStream();
    void this.load();
  }

  #pollLater(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.load(), POLL_MS);
  }

  #closeStream(): void {
    this.#stream?.close();
    this.#stream = undefined;
  }

  #end(): void {
    this.#closeStream();
    clearTimeout(this.#timer);
    this.isPolling = false;
  }

  stop(): void {
    this.#isStopped = true;
    this.#end();
  }
}
