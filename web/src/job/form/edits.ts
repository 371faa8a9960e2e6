// What controls of the form do to the job: set an entry, take it out, add and move entries of lists.

import { jobStore } from "../../state/job.svelte";
import { isTable, type Json, type Path, type Table } from "../../lib/path";

export const setEntry = (path: Path, value: Json): Promise<void> => jobStore.edit([{ path, value }]);

export const removeEntry = (path: Path): Promise<void> => jobStore.edit([{ path, value: null }]);

/** Sets a table entry by entry, so that it gets a heading of its own in the text; entries that it lacks are taken out. */
export function setTable(path: Path, table: Table, before: Json | undefined): Promise<void> {
  const entries = Object.entries(table);
  if (entries.length === 0) return setEntry(path, table);
  const gone = isTable(before) ? Object.keys(before).filter((key) => !(key in table)) : [];
  const edits = [
    ...gone.map((key) => ({ path: [...path, key], value: null })),
    ...entries.map(([key, value]) => ({ path: [...path, key], value })),
  ];
  return jobStore.edit(edits);
}

/** Exchanges two entries of a list. */
export const swapEntries = (path: Path, list: Json[], at: number, other: number): Promise<void> => {
  const moved = [...list];
  [moved[at], moved[other]] = [list[other]!, list[at]!];
  return setEntry(path, moved);
};
