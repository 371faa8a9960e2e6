// Starts a run of the open job and shows it.

import * as api from "../api/client";
import type { RunKind } from "../api/types";
import { router } from "../lib/router.svelte";
import { jobStore } from "../state/job.svelte";
import { notices } from "../state/notices.svelte";
import { runsUnderWay } from "../state/runs.svelte";

export async function startRun(kind: RunKind): Promise<void> {
  try {
    const { id } = await api.startRun(kind, jobStore.job);
    void runsUnderWay.refresh();
    router.go(`/runs/${id}`);
  } catch (error) {
    notices.fail(error);
  }
}
