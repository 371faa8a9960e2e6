// The job under work: its text, the files that it names, what the server says about it, and its history. The text is the truth; the
// form edits it through the server, which keeps comments. Everything survives a reload.

import * as api from "../api/client";
import { asFailure, isAborted, type RequestFailure } from "../api/failure";
import type { CheckAnswer, Edit, Finding, Job } from "../api/types";
import { pathText, type Table } from "../lib/path";
import { Undo, type UndoState } from "../lib/undo";
import { keep, recall } from "./keep";
import { readSetting, writeSetting } from "./settings";

export interface JobState {
  text: string;
  files: Record<string, string>;
  fileName: string;
}

interface Kept {
  present: JobState;
  undo: UndoState<JobState>;
  at: number;
}

const EMPTY: JobState = { text: "", files: {}, fileName: "" };
const CHECK_AFTER_MS = 180;
const KEEP_AFTER_MS = 200;
/** What is written at once when the page is left, while the store of the browser may still be writing. */
const LAST = "job.last";

class JobStore {
  present = $state.raw<JobState>(EMPTY);
  /** Counts changes, so that those who show the job know that it is another. */
  version = $state(0);
  isRestored = $state(false);
  answer = $state.raw<CheckAnswer>();
  /** The last tree that could be read, which the form shows. */
  tree = $state.raw<Table>();
  isChecking = $state(false);
  failure = $state.raw<RequestFailure>();
  /** The entry that the last edit of the form was about, where the server refused it. */
  refusedEdit = $state.raw<{ field: string; failure: RequestFailure }>();
  #undo = $state.raw(new Undo<JobState>());
  #steps = $state({ back: 0, forward: 0 });
  #checkTimer: ReturnType<typeof setTimeout> | undefined;
  #keepTimer: ReturnType<typeof setTimeout> | undefined;
  #abort: AbortController | undefined;
  #edits: Promise<void> = Promise.resolve();

  isEmpty = $derived(this.present.text.trim() === "");
  canUndo = $derived(this.#steps.back > 0);
  canRedo = $derived(this.#steps.forward > 0);
  findings: Finding[] = $derived(this.answer?.findings ?? []);
  isValid = $derived(this.answer?.valid === true && this.failure === undefined);
  process = $derived(this.answer?.process ?? processOf(this.tree));
  name = $derived(this.answer?.name ?? nameOf(this.tree));

  async restore(): Promise<void> {
    const kept = await recall<Kept>("job");
    const last = readLast();
    if (this.version === 0 && (kept || last)) {
      this.#undo = new Undo(kept?.undo);
      const isNewer = last !== undefined && last.at > (kept?.at ?? 0);
      if (isNewer && kept && kept.present.text !== last.present.text) this.#undo.keep(kept.present, "restore", 0);
      this.present = (isNewer ? last : kept)!.present;
      this.#count();
      this.version++;
    }
    this.isRestored = true;
    if (!this.isEmpty) this.checkSoon(0);
  }

  /** The job as it is handed to the server. */
  get job(): Job {
    return { text: this.present.text, files: this.present.files };
  }

  setText(text: string, origin: string): void {
    if (text !== this.present.text) this.#change({ ...this.present, text }, origin);
  }

  /** Opens another job in place of this one; undo brings this one back. */
  replace(job: Job, fileName: string): void {
    this.tree = undefined;
    this.answer = undefined;
    this.#change({ text: job.text, files: job.files ?? {}, fileName }, `open ${fileName}`);
  }

  setFiles(files: Record<string, string>): void {
    this.#change({ ...this.present, files }, "files");
  }

  /** Edits of the form, one after the other, each on the text that the last one left. */
  edit(edits: Edit[]): Promise<void> {
    const work = async (): Promise<void> => {
      const field = pathText(edits[0]?.path ?? []);
      try {
        const before = this.present.text;
        const edited = await api.edit(before, edits);
        if (this.present.text !== before) return;
        this.tree = edited.tree;
        this.refusedEdit = undefined;
        this.setText(edited.text, `form ${field}`);
      } catch (error) {
        this.refusedEdit = { field, failure: asFailure(error) };
        this.version++;
      }
    };
    this.#edits = this.#edits.then(work);
    return this.#edits;
  }

  undo(): void {
    this.#go(this.#undo.undo(this.present));
  }

  redo(): void {
    this.#go(this.#undo.redo(this.present));
  }

  /** Has the job checked once it has been left alone for a moment. */
  checkSoon(after = CHECK_AFTER_MS): void {
    clearTimeout(this.#checkTimer);
    this.#abort?.abort();
    this.isChecking = true;
    this.#checkTimer = setTimeout(() => void this.#check(), after);
  }

  async #check(): Promise<void> {
    const abort = new AbortController();
    this.#abort = abort;
    try {
      const answer = await api.check(this.job, abort.signal);
      this.answer = answer;
      if (answer.tree) this.tree = answer.tree;
      this.failure = undefined;
    } catch (error) {
      if (isAborted(error) || abort.signal.aborted) return;
      this.failure = asFailure(error);
    }
    this.isChecking = false;
  }

  #change(next: JobState, origin: string): void {
    this.#undo.keep(this.present, origin, performance.now());
    this.#take(next);
  }

  #go(state: JobState | undefined): void {
    if (state) this.#take(state);
  }

  #take(state: JobState): void {
    this.present = state;
    this.version++;
    this.#count();
    if (state.text.trim() === "") {
      this.answer = undefined;
      this.tree = undefined;
    }
    this.checkSoon();
    clearTimeout(this.#keepTimer);
    this.#keepTimer = setTimeout(() => void this.#keep(), KEEP_AFTER_MS);
  }

  #count(): void {
    this.#steps = { back: this.#undo.past.length, forward: this.#undo.future.length };
  }

  async #keep(): Promise<void> {
    const kept: Kept = { present: this.present, undo: { past: this.#undo.past, future: this.#undo.future }, at: Date.now() };
    await keep("job", kept);
  }

  /** Keeps what is not kept yet, before the page is left. */
  keepNow(): void {
    if (this.version === 0) return;
    writeSetting(LAST, JSON.stringify({ present: this.present, at: Date.now() }));
    clearTimeout(this.#keepTimer);
    void this.#keep();
  }
}

function readLast(): { present: JobState; at: number } | undefined {
  try {
    return JSON.parse(readSetting(LAST) ?? "") as { present: JobState; at: number };
  } catch {
    return undefined;
  }
}

function processOf(tree: Table | undefined): string | undefined {
  const job = tree?.["job"] as Table | undefined;
  return typeof job?.["process"] === "string" ? job["process"] : undefined;
}

function nameOf(tree: Table | undefined): string | undefined {
  const job = tree?.["job"] as Table | undefined;
  return typeof job?.["name"] === "string" ? job["name"] : undefined;
}

export const jobStore = new JobStore();
