// Flanks as grids of values, taken out of previews and results, and differences between them.

import type { Found, InspectionRound, Preview, ResultDocument } from "../api/types";
import { fractionalIndex, valueInGrid } from "../lib/contours";

export type Quantity = "target" | "planned" | "simulated" | "measured";
export type Side = "left" | "right";
export const QUANTITIES: Quantity[] = ["target", "planned", "simulated", "measured"];
export const SIDES: Side[] = ["left", "right"];

/** A flank over its profile and helix; rows run over the profile. */
export interface FlankField {
  profile: number[];
  helix: number[];
  values: Partial<Record<Quantity, number[][]>>;
  /** Units of profile and helix as the document states them: "mm", "rad", or "1" for fractions. */
  units: { height: string; length: string };
}

export type Flanks = Partial<Record<Side, FlankField>>;

/** A grid that is shown: a quantity, or one less another. */
export interface Shown {
  of: Quantity;
  less?: Quantity;
}

type ToldFlanks = Found<NonNullable<ResultDocument["flanks"] | InspectionRound["flanks"]>>;
type ToldFlank = NonNullable<ToldFlanks[string]>;

export function flanksOfPreview(preview: Preview): Flanks {
  return flanksOf(preview.flanks);
}

/** The flanks of a result; of an inspection those of its last round. */
export function flanksOfDocument(document: ResultDocument | null | undefined): Flanks {
  return flanksOf(document?.rounds ? document.rounds.at(-1)?.flanks : document?.flanks);
}

function flanksOf(told: ToldFlanks | null | undefined): Flanks {
  const flanks: Flanks = {};
  for (const side of SIDES) {
    const flank = told?.[side];
    const field = flank ? fieldOf(flank) : undefined;
    if (field) flanks[side] = field;
  }
  return flanks;
}

function fieldOf(flank: ToldFlank): FlankField | undefined {
  const isInvolute = "w_mm" in flank;
  const profile = numbers(isInvolute ? flank.w_mm : flank.height);
  const helix = numbers(isInvolute ? flank.z_mm : flank.length);
  if (profile.length < 2 || helix.length < 2) return undefined;
  const values: FlankField["values"] = {};
  for (const quantity of QUANTITIES) {
    const grid = gridOf(flank[`${quantity}_um`], profile.length, helix.length);
    if (grid) values[quantity] = grid;
  }
  const standard = isInvolute ? "mm" : "1";
  const units = { height: flank.height_unit ?? standard, length: flank.length_unit ?? standard };
  return Object.keys(values).length === 0 ? undefined : { profile, helix, values, units };
}

function numbers(value: unknown): number[] {
  return Array.isArray(value) ? value.map((some) => (typeof some === "number" ? some : NaN)) : [];
}

/** Rows of a grid; a flat list is cut into rows over the profile. */
function gridOf(value: unknown, rows: number, columns: number): number[][] | undefined {
  if (!Array.isArray(value)) return undefined;
  if (value.length === rows && value.every(Array.isArray)) return value.map(numbers);
  if (value.length !== rows * columns) return undefined;
  const flat = numbers(value);
  return Array.from({ length: rows }, (_, row) => flat.slice(row * columns, (row + 1) * columns));
}

/** The grid that is shown of a flank, where it has it. */
export function shownGrid(field: FlankField | undefined, shown: Shown): number[][] | undefined {
  const of = field?.values[shown.of];
  if (!of || !shown.less) return of;
  const less = field.values[shown.less];
  return less && minus(of, less);
}

export function minus(a: number[][], b: number[][]): number[][] {
  return a.map((row, i) => row.map((value, j) => value - (b[i]?.[j] ?? NaN)));
}

/** A grid of one field taken at the places of another; NaN outside. */
export function resampled(grid: number[][], from: FlankField, to: FlankField): number[][] {
  const inside = (list: number[], value: number): boolean => {
    const [low, high] = [list[0]!, list.at(-1)!];
    const slack = 1e-9 * Math.abs(high - low);
    return value >= low - slack && value <= high + slack;
  };
  return to.profile.map((w) =>
    to.helix.map((z) =>
      inside(from.profile, w) && inside(from.helix, z)
        ? valueInGrid(grid, fractionalIndex(from.profile, w), fractionalIndex(from.helix, z))
        : NaN,
    ),
  );
}

/** What can be shown of flanks: quantities first, then differences from the target and between what follows each other. */
export function choices(flanks: Flanks): Shown[] {
  const has = (quantity: Quantity): boolean => SIDES.some((side) => flanks[side]?.values[quantity] !== undefined);
  const there = QUANTITIES.filter(has);
  const differences: Shown[] = [];
  for (const [at, of] of there.entries()) {
    for (const less of there.slice(0, at)) differences.push({ of, less });
  }
  return [...there.map((of) => ({ of })), ...differences];
}

export const shownKey = (shown: Shown): string => (shown.less ? `${shown.of}-${shown.less}` : shown.of);

/** Largest magnitude and root mean square of a grid. */
export function gridFigures(grid: number[][]): { largest: number; rms: number } {
  const flat = grid.flat().filter(Number.isFinite);
  const largest = flat.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const rms = Math.sqrt(flat.reduce((sum, value) => sum + value * value, 0) / Math.max(1, flat.length));
  return { largest, rms };
}
