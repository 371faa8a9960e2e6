// Values of characteristics over parts: which are comparable, which are beyond their limits.

import type { TrendPoint } from "../api/types";

/** Symbols of characteristics in the store, grouped as on a sheet. */
export const CHARACTERISTICS = [
  { group: "profile", names: ["fHa", "Fa", "ffa", "Ca", "fKo"] },
  { group: "helix", names: ["fHb", "Fb", "ffb", "Cb"] },
  { group: "pitch", names: ["fp", "fu", "Rp", "Fp", "Fpk"] },
  { group: "gear", names: ["Fr", "Rs", "fe", "x-span", "x-balls", "class"] },
] as const;

export interface TrendLine {
  flank: string;
  points: TrendPoint[];
}

export const isBeyond = (point: TrendPoint): boolean =>
  (point.upper_limit !== null && point.upper_limit !== undefined && point.value > point.upper_limit) ||
  (point.lower_limit !== null && point.lower_limit !== undefined && point.value < point.lower_limit);

/** The statistics that values have, the mean first. */
export function statisticsOf(points: TrendPoint[]): string[] {
  const all = [...new Set(points.map((point) => point.statistic))];
  return all.sort((a, b) => Number(b === "mean") - Number(a === "mean") || a.localeCompare(b));
}

/** One line for each flank, points in the order of measuring. */
export function linesOf(points: TrendPoint[], statistic: string): TrendLine[] {
  const some = points.filter((point) => point.statistic === statistic);
  const flanks = [...new Set(some.map((point) => point.flank ?? ""))].sort();
  return flanks.map((flank) => ({ flank, points: some.filter((point) => (point.flank ?? "") === flank) }));
}

/** Parts in the order in which they were first met, as places of the abscissa. */
export function placesOf(lines: TrendLine[]): string[] {
  const points = lines.flatMap((line) => line.points);
  const dated = [...new Map(points.map((point) => [point.digest, point])).values()];
  return dated.sort((a, b) => (a.date ?? "~").localeCompare(b.date ?? "~")).map((point) => point.digest);
}

/** The range of values and limits with room on both sides. */
export function rangeOf(lines: TrendLine[]): [number, number] {
  const all = lines.flatMap((line) => line.points.flatMap((point) => [point.value, point.lower_limit, point.upper_limit]));
  const values = all.filter((value): value is number => typeof value === "number" && Number.isFinite(value));
  if (values.length === 0) return [-1, 1];
  const [low, high] = [Math.min(...values, 0), Math.max(...values, 0)];
  const room = (high - low || 1) * 0.08;
  return [low === 0 ? 0 : low - room, high === 0 ? 0 : high + room];
}
