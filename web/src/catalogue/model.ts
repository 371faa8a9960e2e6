// Bodies of the catalogue as rows of a table, and as the table of a job.

import { isTable, type Json, type Table } from "../lib/path";

/** What a catalogue says of a body that a job does not. */
const ONLY_IN_CATALOGUE = ["name", "smallest_pitch_diameter", "smallest_tip_diameter", "flank_diameters", "notes"];

/** A body with its nested tables laid out: `designed_for.threads`. */
export function flatBody(body: Table, before = ""): Record<string, Json> {
  return Object.fromEntries(
    Object.entries(body).flatMap(([key, value]) =>
      isTable(value) ? Object.entries(flatBody(value, `${before}${key}.`)) : value === null ? [] : [[before + key, value]],
    ),
  );
}

/** All columns that a list of bodies has, in the order in which they first appear; the name first. */
export function columnsOf(bodies: Table[]): string[] {
  const all = new Set(bodies.flatMap((body) => Object.keys(flatBody(body))));
  return ["name", ...[...all].filter((column) => column !== "name")];
}

/** The table of a job that takes this body. */
export function entryForJob(kind: string, body: Table): Table {
  const kept = Object.entries(body).filter(([key, value]) => value !== null && !ONLY_IN_CATALOGUE.includes(key));
  const entry: Table = Object.fromEntries(kept);
  return kind === "dresser" && !("modification" in entry) ? { ...entry, modification: "none" } : entry;
}
