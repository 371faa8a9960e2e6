// Flanks out of results, and what can be shown of them.

import { describe, expect, it } from "vitest";
import { pairsOf, numberRows, differs } from "../src/compare/model";
import { choices, flanksOfDocument, gridFigures, resampled, shownGrid, shownKey } from "../src/plan/surfaces";

const flank = (offset: number) => ({
  w_mm: [4, 10, 20],
  z_mm: [-10, 10],
  target_um: [
    [0, 0],
    [0, 0],
    [0, 0],
  ],
  simulated_um: [
    [offset, 1],
    [0, 0],
    [0, -2],
  ],
});

describe("flanksOfDocument", () => {
  it("takes grids of a plan", () => {
    const flanks = flanksOfDocument({ flanks: { left: flank(3) } });
    expect(Object.keys(flanks)).toEqual(["left"]);
    expect(flanks.left!.units).toEqual({ height: "mm", length: "mm" });
    expect(choices(flanks).map(shownKey)).toEqual(["target", "simulated", "simulated-target"]);
    expect(gridFigures(shownGrid(flanks.left, { of: "simulated", less: "target" })!).largest).toBe(3);
  });
  it("cuts flat lists of milled flanks into rows over the height", () => {
    const flanks = flanksOfDocument({
      flanks: { right: { height: [1, 2], length: [0, 5, 10], planned_um: [1, 2, 3, 4, 5, 6] } },
    });
    expect(flanks.right!.values.planned).toEqual([
      [1, 2, 3],
      [4, 5, 6],
    ]);
    expect(flanks.right!.units).toEqual({ height: "1", length: "1" });
  });
  it("takes the last round of an inspection, and nothing where there is no surface", () => {
    const rounds = [{ flanks: { left: flank(1) } }, { flanks: { left: flank(9) } }];
    expect(flanksOfDocument({ rounds }).left!.values.simulated![0]![0]).toBe(9);
    expect(flanksOfDocument({ flanks: { left: { w_mm: [1, 2], z_mm: [0], target_um: [[0], [0]] } } })).toEqual({});
    expect(flanksOfDocument(undefined)).toEqual({});
  });
});

describe("comparison", () => {
  const a = flanksOfDocument({ flanks: { left: flank(3) } });
  const b = flanksOfDocument({ flanks: { left: flank(5) } });
  it("takes the difference place by place", () => {
    const [pair] = pairsOf(a, b, "simulated", "target");
    expect(pair!.difference[0]).toEqual([2, 0]);
    expect(pair!.isResampled).toBe(false);
  });
  it("takes the second at the places of the first where grids differ, and nothing outside of it", () => {
    const to = { ...a.left!, profile: [4, 7, 30] };
    const grid = resampled(b.left!.values.simulated!, b.left!, to);
    expect(grid[0]).toEqual([5, 1]);
    expect(grid[1]![0]).toBeCloseTo(2.5, 12);
    expect(grid[2]![0]).toBeNaN();
  });
  it("finds the numbers that differ", () => {
    const rows = numberRows({ a: 1, b: { c: 2 }, timing_s: { x: 1 } }, { a: 1, b: { c: 3 } });
    expect(rows.map((row) => row.path)).toEqual(["a", "b.c"]);
    expect(rows.filter(differs).map((row) => row.path)).toEqual(["b.c"]);
  });
});
