// A combination of a study taken into the job that was studied, and into no other.

import type { Edit } from "../api/types";
import { isTable, valueAt, withValue, type Json, type Path, type Table } from "../lib/path";
import type { Candidate, Study } from "./model";

/** Where the quantities of studies stand in a job; a crossing angle comes about by the pitch diameter of the worm. */
const PLACES: Record<string, Path[]> = {
  diagonal_ratio: [["grinding", "diagonal_ratio"]],
  worm_cone_angle_deg: [["worm", "cone_angle_deg"]],
  crossed_axes_angle_deg: [
    ["worm", "pitch_diameter"],
    ["worm", "tip_diameter"],
  ],
};
/** What says nothing of the part: which combinations are tried, what is written, and words. */
const ASIDE: Path[] = [["explore"], ["output"], ["job", "description"]];

/** Whether two jobs are the same but for what a study varies. Both come as trees with the files that they name. */
export function isStudiedJob(
  open: { tree: Table; files: Record<string, string> },
  studied: { tree: Table; files: Record<string, string> },
  varied: string[],
): boolean {
  const left = [...ASIDE, ...varied.flatMap((key) => PLACES[key] ?? [])];
  const rest = (tree: Table): string => canonical(left.reduce<Json>((job, path) => without(job, path), tree));
  return rest(open.tree) === rest(studied.tree) && canonical(open.files) === canonical(studied.files);
}

/** Takes an entry out; tables on its way are not made. */
function without(tree: Json, path: Path): Json {
  return valueAt(tree, path) === undefined ? tree : withValue(tree, path, undefined);
}

/** A value as text with its keys in order. */
function canonical(value: Json): string {
  if (Array.isArray(value)) return `[${value.map(canonical).join()}]`;
  if (!isTable(value)) return JSON.stringify(value);
  const entries = Object.keys(value)
    .sort()
    .map((key) => `${JSON.stringify(key)}:${canonical(value[key] ?? null)}`);
  return `{${entries.join()}}`;
}

/** The edits that make a job that of a combination; undefined for one that is refused or has no value for what varies. */
export function editsOf(study: Study, candidate: Candidate | undefined, tree: Table): Edit[] | undefined {
  if (!candidate?.allowed) return undefined;
  const edits: Edit[] = [];
  for (const key of study.varied) {
    const value = candidate.at[key];
    if (value === undefined) return undefined;
    if (key === "crossed_axes_angle_deg") {
      const pitch = candidate.wormPitchDiameter;
      if (pitch === undefined) return undefined;
      edits.push(...wormEdits(tree, pitch));
    } else edits.push(...(PLACES[key] ?? []).map((path) => ({ path, value: Number(value.toPrecision(12)) })));
  }
  return edits.length > 0 ? edits : undefined;
}

/** Another pitch diameter; the addendum that the job gives stays. */
function wormEdits(tree: Table, pitch: number): Edit[] {
  const before = valueAt(tree, ["worm", "pitch_diameter"]);
  const tip = valueAt(tree, ["worm", "tip_diameter"]);
  const edits: Edit[] = [{ path: ["worm", "pitch_diameter"], value: pitch }];
  if (typeof tip === "number") {
    const value = typeof before === "number" ? Number((tip - before + pitch).toPrecision(12)) : null;
    edits.push({ path: ["worm", "tip_diameter"], value });
  }
  return edits;
}
