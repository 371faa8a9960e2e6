// Which tabs the result of a run has.

import type { Run } from "../api/types";
import { flanksOfDocument } from "../plan/surfaces";

export type RunTab =
  | "summary"
  | "reason"
  | "flank"
  | "motions"
  | "process"
  | "programs"
  | "inspection"
  | "systematic"
  | "study"
  | "report"
  | "files"
  | "numbers";

/** The page for reading that a run wrote: the report, the series, or the study. */
export function reportOf(run: Run): string | undefined {
  return ["report.html", "series.html", "explore.html"].find((name) => run.files.some((file) => file.name === name));
}

export function sheetsOf(run: Run): string[] {
  return run.files.map((file) => file.name).filter((name) => name === "sheet.html" || /^sheets\/.*\.html$/.test(name));
}

/** Whether a run has something to show beside its state: a result, or what a refused job wrote. */
export function hasTabs(run: Run): boolean {
  return run.state === "done" || (run.state === "failed" && reportOf(run) !== undefined);
}

export function tabsOf(run: Run): RunTab[] {
  const document = run.document ?? {};
  const isRefused = run.state === "failed";
  const isStudy = run.kind === "explore";
  const has: Record<RunTab, boolean> = {
    study: isStudy && !isRefused,
    summary: !isStudy && !isRefused,
    reason: isRefused,
    inspection: sheetsOf(run).length > 0,
    systematic: (document.rounds ?? []).length > 0,
    flank: Object.keys(flanksOfDocument(document)).length > 0,
    motions: run.charts.length > 0,
    process: run.scene,
    programs: run.files.some((file) => file.name.startsWith("programs/")),
    report: reportOf(run) !== undefined,
    files: true,
    numbers: run.document !== undefined && run.document !== null,
  };
  return (Object.keys(has) as RunTab[]).filter((tab) => has[tab]);
}
