// Studies over the catalogue: pairs of worm and dresser as they are, or with one quantity of the worm left free.

import type { ResultDocument } from "../api/types";

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

type Told = NonNullable<ResultDocument["pairs"]>[number];
type Flanks = Told["flanks"];

/** The value of the flank on which it is larger in magnitude. */
function largest(flanks: Flanks, key: "stretch" | "profile_error_um"): number | undefined {
  const values = Object.values(flanks ?? {}).flatMap((flank) => flank?.[key] ?? []);
  return values.length === 0 ? undefined : values.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most));
}

/** The ranked pairs of a catalogue; none in other studies. */
export function pairsOf(document: ResultDocument | null | undefined): Pair[] {
  return (document?.pairs ?? []).flatMap(({ rank, refused, life, ...row }): Pair[] => {
    if (rank == null) return [];
    return [
      {
        rank,
        worm: row.worm ?? "",
        dresser: row.dresser ?? "",
        ok: row.ok === true,
        share: row.largest_share_of_limit ?? undefined,
        stretch: largest(row.flanks, "stretch"),
        profileError: largest(row.flanks, "profile_error_um"),
        diameter: row.worm_pitch_diameter_mm ?? undefined,
        lastDiameter: life?.to_mm ?? undefined,
        refused: refused?.text ?? "",
        code: refused?.code ?? "",
        endedBy: life?.ended_by?.text ?? "",
      },
    ];
  });
}

/** The pairs of a study with a free quantity; none in other studies. */
export function freePairsOf(document: ResultDocument | null | undefined): FreePair[] {
  if (!document?.free) return [];
  return (document.pairs ?? []).flatMap((pair): FreePair[] => {
    const names = { worm: pair.worm ?? "", dresser: pair.dresser ?? "" };
    if (!pair.ranges?.length) return [{ ...names, ...NO_RANGE, ...nearest(pair) }];
    return pair.ranges.map(({ from, to, best }) => ({
      ...names,
      from: from ?? undefined,
      to: to ?? undefined,
      best: best?.value ?? undefined,
      share: best?.largest_share_of_limit ?? undefined,
      stretch: largest(best?.flanks, "stretch"),
      refused: "",
      refusedAt: undefined,
    }));
  });
}

const NO_RANGE = { from: undefined, to: undefined, best: undefined, share: undefined, stretch: undefined };

/** What forbids a pair as a whole, or else the point of it that is nearest to what is allowed. */
function nearest(pair: Told): { refused: string; refusedAt: number | undefined } {
  const refused = pair.refused?.text;
  if (refused) return { refused, refusedAt: undefined };
  const points = (pair.points ?? []).filter((point) => point.largest_share_of_limit != null);
  const least = points.reduce<(typeof points)[number]>(
    (least, some) => (some.largest_share_of_limit! < (least.largest_share_of_limit ?? Infinity) ? some : least),
    {},
  );
  return { refused: least.refused?.text ?? "", refusedAt: least.value ?? undefined };
}

/** The unit of the quantity that is free. */
export const unitOfFree = (free: string): string => ({ "pitch-diameter": "mm", "pressure-angle": "°" })[free] ?? "";
