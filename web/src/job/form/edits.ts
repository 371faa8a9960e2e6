// What controls of the form do to the job: set an entry, take it out, add and move entries of lists.

import { jobStore } from "../../state/job.svelte";
import type { Json, Path } from "../../lib/path";

export const setEntry = (path: Path, value: Json): Promise<void> => jobStore.edit([{ path, value }]);

export const removeEntry = (path: Path): Promise<void> => jobStore.edit([{ path, value: null }]);

/** Exchanges two entries of a list. */
export const swapEntries = (path: Path, list: Json[], at: number, other: number): Promise<void> => {
  const moved = [...list];
  [moved[at], moved[other]] = [list[other]!, list[at]!];
  return setEntry(path, moved);
};
