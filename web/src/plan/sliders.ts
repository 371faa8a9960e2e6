// The amounts of a job that sliders move: modifications, edge amounts and the diagonal ratio.

import { isTable, valueAt, type Path, type Table } from "../lib/path";

export interface Slider {
  path: Path;
  /** What it moves, as a key of the job. */
  key: string;
  flank: string;
  value: number;
  most: number;
  step: number;
  unit: string;
}

/** A range that leaves room on both sides and ends at a round number. */
function roomFor(value: number, least: number): number {
  const wanted = Math.max(least, Math.abs(value) * 2.5);
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((step) => step * power).find((most) => most >= wanted * 0.999) ?? wanted;
}

export function slidersOf(tree: Table | undefined): Slider[] {
  if (!tree) return [];
  const sliders: Slider[] = [];
  const modifications = valueAt(tree, ["target", "modifications"]);
  if (Array.isArray(modifications)) {
    modifications.forEach((entry, at) => {
      if (!isTable(entry) || typeof entry["amount_um"] !== "number") return;
      const value = entry["amount_um"];
      const path: Path = ["target", "modifications", at, "amount_um"];
      const flank = typeof entry["flank"] === "string" ? entry["flank"] : "both";
      sliders.push({ path, key: String(entry["kind"]), flank, value, most: roomFor(value, 20), step: 0.1, unit: "µm" });
    });
  }
  const edges = valueAt(tree, ["target", "edge_amounts"]);
  if (isTable(edges)) {
    const sides: [string, Path][] =
      "left" in edges || "right" in edges
        ? [
            ["left", ["left"]],
            ["right", ["right"]],
          ]
        : [["both", []]];
    for (const [flank, below] of sides) {
      const amounts = valueAt(edges, below);
      if (!isTable(amounts)) continue;
      for (const [key, value] of Object.entries(amounts)) {
        if (typeof value !== "number") continue;
        const path: Path = ["target", "edge_amounts", ...below, key];
        sliders.push({ path, key, flank, value, most: roomFor(value, 20), step: 0.1, unit: "µm" });
      }
    }
  }
  return sliders;
}

/** The entry that holds the ratio of shift to feed: its path and its value, a word where a rule chooses it. */
export function ratioOf(tree: Table | undefined): { path: Path; value: number | string | undefined } | undefined {
  const grinding = tree?.["grinding"];
  if (!isTable(grinding)) return undefined;
  const job = tree?.["job"];
  const isTangential = isTable(job) && job["process"] === "tangential-dressing";
  if (!isTangential && grinding["method"] === "radial") return undefined;
  const key = isTangential ? "shift_ratio" : "diagonal_ratio";
  const value = grinding[key];
  if (value !== undefined && typeof value !== "number" && typeof value !== "string") return undefined;
  return { path: ["grinding", key], value };
}

/** Whether the job asks for a modification of this kind. */
export function asksFor(tree: Table | undefined, kind: string): boolean {
  const modifications = tree && valueAt(tree, ["target", "modifications"]);
  return Array.isArray(modifications) && modifications.some((entry) => isTable(entry) && entry["kind"] === kind);
}
