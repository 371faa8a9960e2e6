// Studies over the catalogue: pairs of worm and dresser as they are, or with one quantity of the worm left free.

import { isTable, type Json, type Table } from "../lib/path";

export interface Pair {
  rank: number;
  worm: string;
  dresser: string;
  /** Whether the pair makes the profile within all limits. */
  ok: boolean;
  /** Largest share of an axis limit. */
  share: number | undefined;
  stretch: number | undefined;
  profileError: number | undefined;
  /** Pitch diameters of the worm of now and at the end of its life. */
  diameter: number | undefined;
  lastDiameter: number | undefined;
  /** Why the pair does not make the profile, and in a word; what ends the life of its worm early. */
  refused: string;
  code: string;
  endedBy: string;
}

/** A pair over the free quantity: one row for each range in which it makes the profile, or one without a range. */
export interface FreePair {
  worm: string;
  dresser: string;
  from: number | undefined;
  to: number | undefined;
  best: number | undefined;
  share: number | undefined;
  stretch: number | undefined;
  /** What forbids it, at the value that is nearest to what is allowed. */
  refused: string;
  refusedAt: number | undefined;
}

const number = (value: Json | undefined): number | undefined => (typeof value === "number" ? value : undefined);
const word = (value: Json | undefined): string => (typeof value === "string" ? value : "");
const tables = (value: Json | undefined): Table[] => (Array.isArray(value) ? value.filter(isTable) : []);
const table = (value: Json | undefined): Table => (isTable(value) ? value : {});

/** The value of the flank on which it is larger in magnitude. */
function largest(flanks: Json | undefined, key: string): number | undefined {
  const values = Object.values(table(flanks)).flatMap((flank) => number(table(flank)[key]) ?? []);
  return values.length === 0 ? undefined : values.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most));
}

/** The ranked pairs of a catalogue; none in other studies. */
export function pairsOf(document: Table | null | undefined): Pair[] {
  const rows = tables(document?.["pairs"]).filter((row) => typeof row["rank"] === "number");
  return rows.map((row) => {
    const [refused, life] = [table(row["refused"]), table(row["life"])];
    return {
      rank: row["rank"] as number,
      worm: word(row["worm"]),
      dresser: word(row["dresser"]),
      ok: row["ok"] === true,
      share: number(row["largest_share_of_limit"]),
      stretch: largest(row["flanks"], "stretch"),
      profileError: largest(row["flanks"], "profile_error_um"),
      diameter: number(row["worm_pitch_diameter_mm"]),
      lastDiameter: number(life["to_mm"]),
      refused: word(refused["text"]),
      code: word(refused["code"]),
      endedBy: word(table(life["ended_by"])["text"]),
    };
  });
}

/** The pairs of a study with a free quantity; none in other studies. */
export function freePairsOf(document: Table | null | undefined): FreePair[] {
  if (typeof document?.["free"] !== "string") return [];
  return tables(document["pairs"]).flatMap((pair): FreePair[] => {
    const names = { worm: word(pair["worm"]), dresser: word(pair["dresser"]) };
    const ranges = tables(pair["ranges"]);
    if (ranges.length === 0) return [{ ...names, ...NO_RANGE, ...nearest(pair) }];
    return ranges.map((range) => {
      const best = table(range["best"]);
      return {
        ...names,
        from: number(range["from"]),
        to: number(range["to"]),
        best: number(best["value"]),
        share: number(best["largest_share_of_limit"]),
        stretch: largest(best["flanks"], "stretch"),
        refused: "",
        refusedAt: undefined,
      };
    });
  });
}

const NO_RANGE = { from: undefined, to: undefined, best: undefined, share: undefined, stretch: undefined };

/** What forbids a pair as a whole, or else the point of it that is nearest to what is allowed. */
function nearest(pair: Table): { refused: string; refusedAt: number | undefined } {
  const refused = word(table(pair["refused"])["text"]);
  if (refused) return { refused, refusedAt: undefined };
  const share = (point: Table): number => number(point["largest_share_of_limit"]) ?? Infinity;
  const point = tables(pair["points"]).reduce<Table>((least, some) => (share(some) < share(least) ? some : least), {});
  return { refused: word(table(point["refused"])["text"]), refusedAt: number(point["value"]) };
}

/** The unit of the quantity that is free. */
export const unitOfFree = (free: string): string => ({ "pitch-diameter": "mm", "pressure-angle": "°" })[free] ?? "";
