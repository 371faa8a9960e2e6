// What every part of the form needs: the schema, and an id for the field at a path.

import { getContext, setContext } from "svelte";
import type { JobSchema } from "../../lib/schema";
import { pathText, type Path } from "../../lib/path";
import { jobStore } from "../../state/job.svelte";

const KEY = Symbol("form");

export const provideSchema = (schema: JobSchema): JobSchema => setContext(KEY, schema);
export const useSchema = (): JobSchema => getContext<JobSchema>(KEY);
/** What describes the field at a path to those who do not see it: its own complaint where it has one, what was found about it, its help. */
export function described(path: Path, complains = false): { isFound: boolean; by: string } {
  const name = pathText(path);
  const isFound = jobStore.findings.some((finding) => finding.field === name) || jobStore.refusedEdit?.field === name;
  const id = fieldId(path);
  return {
    isFound,
    by: [complains ? `${id}-complaint` : "", isFound ? `${id}-findings` : "", `${id}-help`].filter(Boolean).join(" "),
  };
}

export const fieldId = (path: Path): string => `field-${pathText(path).replace(/[^A-Za-z0-9_-]/g, "-")}`;
