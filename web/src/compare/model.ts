// Two documents as rows of numbers with their differences, and two flanks on the grid of the first.

import { isTable, type Table } from "../lib/path";
import { minus, resampled, SIDES, type FlankField, type Flanks, type Quantity, type Side } from "../plan/surfaces";

export interface NumberRow {
  path: string;
  key: string;
  group: string;
  first: number | undefined;
  second: number | undefined;
}

/** All single numbers of a document by their path; grids and times are left out. */
export function numbersOf(table: Table, before = ""): Map<string, number> {
  const found = new Map<string, number>();
  for (const [key, value] of Object.entries(table)) {
    if (key === "timing_s" || key === "candidates") continue;
    if (typeof value === "number") found.set(before + key, value);
    else if (isTable(value)) for (const [path, number] of numbersOf(value, `${before}${key}.`)) found.set(path, number);
  }
  return found;
}

export function numberRows(first: Table, second: Table): NumberRow[] {
  const [a, b] = [numbersOf(first), numbersOf(second)];
  const paths = [...new Set([...a.keys(), ...b.keys()])];
  return paths.map((path) => {
    const steps = path.split(".");
    return { path, key: steps.at(-1)!, group: steps.slice(0, -1).join("."), first: a.get(path), second: b.get(path) };
  });
}

/** Whether two numbers differ by more than the last digit that is computed. */
export function differs(row: NumberRow): boolean {
  if (row.first === undefined || row.second === undefined) return row.first !== row.second;
  return Math.abs(row.first - row.second) > 1e-9 * Math.max(1, Math.abs(row.first), Math.abs(row.second));
}

export interface PairOfGrids {
  side: Side;
  field: FlankField;
  first: number[][];
  second: number[][];
  difference: number[][];
  isResampled: boolean;
}

/** The flanks that both results have, the second at the places of the first, and the second less the first. */
export function pairsOf(a: Flanks, b: Flanks, quantity: Quantity, less: Quantity | undefined): PairOfGrids[] {
  return SIDES.flatMap((side) => {
    const [one, other] = [a[side], b[side]];
    const first = one && gridOf(one, quantity, less);
    const raw = other && gridOf(other, quantity, less);
    // Places in other units are not the same places.
    const isComparable = one?.units.height === other?.units.height && one?.units.length === other?.units.length;
    if (!one || !other || !first || !raw || !isComparable) return [];
    const isSame = sameList(one.profile, other.profile) && sameList(one.helix, other.helix);
    const second = isSame ? raw : resampled(raw, other, one);
    return [{ side, field: one, first, second, difference: minus(second, first), isResampled: !isSame }];
  });
}

function gridOf(field: FlankField, quantity: Quantity, less: Quantity | undefined): number[][] | undefined {
  const of = field.values[quantity];
  const from = less && field.values[less];
  return less ? of && from && minus(of, from) : of;
}

const sameList = (a: number[], b: number[]): boolean =>
  a.length === b.length && a.every((value, at) => Math.abs(value - b[at]!) < 1e-9);
