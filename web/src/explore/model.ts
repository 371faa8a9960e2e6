// A study: its candidates, and what varies among them.

import type { ResultDocument } from "../api/types";
import { isTable, type Table } from "../lib/path";
import { unitOfKey } from "../lib/units";

export interface Candidate {
  rank: number;
  allowed: boolean;
  isWithin: boolean;
  residual: number | undefined;
  score: number | undefined;
  wormLength: number | undefined;
  determinant: number | undefined;
  refused: string;
  /** Values of what varies, by key. */
  at: Record<string, number | undefined>;
  wormPitchDiameter: number | undefined;
}

export interface Study {
  varied: string[];
  tolerance: number | undefined;
  ranking: string;
  candidates: Candidate[];
}

const number = (value: unknown): number | undefined => (typeof value === "number" ? value : undefined);

export function studyOf(document: ResultDocument | null | undefined): Study {
  const varied = document?.varied ?? [];
  return {
    varied,
    tolerance: document?.tolerance_um ?? undefined,
    ranking: document?.ranking ?? "",
    candidates: (document?.candidates ?? []).map((row, at) => ({
      rank: row.rank ?? at + 1,
      allowed: row.allowed === true,
      isWithin: row.within_tolerance === true,
      residual: row.residual_um ?? undefined,
      score: row.score ?? undefined,
      wormLength: row.worm_occupation_mm ?? undefined,
      determinant: row.least_determinant_ratio ?? undefined,
      refused: row.refused?.text ?? row.refused?.code ?? "",
      at: Object.fromEntries(varied.map((key) => [key, number((row as Table)[key])])),
      wormPitchDiameter: row.worm_pitch_diameter_mm ?? undefined,
    })),
  };
}

export interface Curve {
  name: string;
  figures: Table;
}

/** The curves of a study of dressing with what is said of each; none in other studies. */
export function curvesOf(document: ResultDocument | null | undefined): Curve[] {
  const { crowning, profile, worms, strokes, deviations } = document ?? {};
  const lists: (unknown[] | null | undefined)[] = [crowning, profile, worms, strokes, deviations];
  const curves = (lists.find((list) => list) ?? []).filter(isTable);
  return curves.map(({ bodies, name, points, ...figures }) => ({ name: String(bodies || name || ""), figures }));
}

export const unitOfVaried = (key: string): string => unitOfKey(key);

/** Powers of ten that enclose positive values. */
export function decades(values: number[]): { low: number; high: number } {
  const positive = values.filter((value) => value > 0);
  if (positive.length === 0) return { low: -3, high: 1 };
  const low = Math.floor(Math.log10(Math.min(...positive)));
  const high = Math.ceil(Math.log10(Math.max(...positive)));
  return { low, high: Math.max(high, low + 1) };
}

/** The decimals that ticks need, all of them alike. */
export function decimalsOf(ticks: number[]): number {
  return Math.max(0, ...ticks.map((tick) => (/\.(\d+)$/.exec(tick.toFixed(9).replace(/0+$/, ""))?.[1] ?? "").length));
}

/** Round ticks over a range. */
export function ticks(from: number, to: number, wanted = 6): number[] {
  const span = to - from;
  if (!(span > 0)) return [from];
  const raw = span / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((some) => some >= raw) ?? raw;
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, at) => Number(((first + at) * step).toPrecision(12)));
}
