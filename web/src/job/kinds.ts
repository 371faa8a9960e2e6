// Which runs a job can begin besides that of its plan.

import type { Table } from "../lib/path";

export const canExplore = (process: string | null | undefined): boolean => process === "generating-grinding";

/** Grinding and dressing are simulated with the settings that a plan wrote into its job. */
export function canSimulate(process: string | null | undefined, tree: Table | undefined): boolean {
  if (process === "skiving-tool-measuring") return true;
  return (process === "generating-grinding" || process === "tangential-dressing") && tree !== undefined && "settings" in tree;
}
