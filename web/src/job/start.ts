// Starts a run of the open job and shows it.

import * as api from "../api/client";
import type { RunKind } from "../api/types";
import { once } from "../lib/once";
import { router } from "../lib/router.svelte";
import { jobStore } from "../state/job.svelte";
import { notices } from "../state/notices.svelte";
import { runsUnderWay } from "../state/runs.svelte";

/** A second call while the first is under way starts nothing: a double click is one run. */
export const startRun = once(async (kind: RunKind): Promise<void> => {
  try {
    const { id } = await api.startRun(kind, jobStore.job);
    void runsUnderWay.refresh();
    router.go(`/runs/${id}`);
  } catch (error) {
    notices.fail(error);
  }
});
