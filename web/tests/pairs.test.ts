// Studies over the catalogue and of dressing: what is shown of their pairs and curves.

import { describe, expect, it } from "vitest";
import { curvesOf } from "../src/explore/model";
import type { Table } from "../src/lib/path";
import { freePairsOf, pairsOf, unitOfFree } from "../src/explore/pairs";

const refused = { code: "axis-limit", text: "Δγ = 4.99° exceeds its limit 3°", way_out: "take another" };

describe("ranked pairs", () => {
  const document: Table = {
    pairs: [
      {
        rank: 1,
        worm: "W3",
        dresser: "D1",
        ok: true,
        largest_share_of_limit: 0.025,
        worm_pitch_diameter_mm: 196.25,
        flanks: { left: { stretch: -0.03, profile_error_um: 0.1 }, right: { stretch: 0.01, profile_error_um: 0.2 } },
        life: { from_mm: 196.25, to_mm: 169.25, ended_by: null },
        refused: null,
      },
      { rank: 2, worm: "W4", dresser: "D1", ok: false, largest_share_of_limit: null, flanks: {}, life: null, refused },
    ],
  };
  it("have the figures of the flank on which they are larger", () => {
    const [first] = pairsOf(document);
    expect(first).toMatchObject({ rank: 1, ok: true, stretch: -0.03, profileError: 0.2, diameter: 196.25, lastDiameter: 169.25 });
    expect(first).toMatchObject({ refused: "", endedBy: "" });
  });
  it("say why they do not make the profile", () => {
    expect(pairsOf(document)[1]).toMatchObject({ ok: false, share: undefined, stretch: undefined, refused: refused.text });
  });
  it("are none in other studies", () => {
    expect(pairsOf({ candidates: [] })).toEqual([]);
    expect(freePairsOf(document)).toEqual([]);
  });
});

describe("pairs with a free quantity", () => {
  const point = (value: number, share: number | null) => ({ value, largest_share_of_limit: share, refused });
  const rows = freePairsOf({
    free: "pitch-diameter",
    pairs: [
      {
        worm: "W4",
        dresser: "D1",
        refused: null,
        points: [],
        ranges: [
          { from: 170, to: 200, best: { value: 180, largest_share_of_limit: 0.2, flanks: { left: { stretch: 0.01 } } } },
          { from: 240, to: 280, best: { value: 248, largest_share_of_limit: 0.1, flanks: {} } },
        ],
      },
      { worm: "W5", dresser: "D1", refused: null, ranges: [], points: [point(80, null), point(90, 3), point(100, 2)] },
      { worm: "W6", dresser: "D1", refused: { code: "not-mating", text: "no mesh" }, ranges: [], points: [] },
    ],
  });
  it("have a row for each range", () => {
    expect(rows.map((row) => [row.worm, row.from, row.best])).toEqual([
      ["W4", 170, 180],
      ["W4", 240, 248],
      ["W5", undefined, undefined],
      ["W6", undefined, undefined],
    ]);
    expect(rows[0]!.stretch).toBe(0.01);
  });
  it("say what forbids the value nearest to what is allowed, or the pair as a whole", () => {
    expect(rows[2]).toMatchObject({ refusedAt: 100, refused: refused.text });
    expect(rows[3]).toMatchObject({ refusedAt: undefined, refused: "no mesh" });
  });
  it("have the unit of what is free", () => {
    expect(["pitch-diameter", "pressure-angle", "threads"].map(unitOfFree)).toEqual(["mm", "°", ""]);
  });
});

describe("curves of dressing", () => {
  it("go without their points", () => {
    const study = { crowning: [{ bodies: "z_S = 3", points: [{ crowning_um: 1 }], least: { crowning_um: -0.4 } }] };
    expect(curvesOf(study)).toEqual([{ name: "z_S = 3", figures: { least: { crowning_um: -0.4 } } }]);
    expect(curvesOf({ profile: [{ name: "c_α = 0 µm", refused: null }] })[0]!.name).toBe("c_α = 0 µm");
    expect(curvesOf({ pairs: [] })).toEqual([]);
  });
});
