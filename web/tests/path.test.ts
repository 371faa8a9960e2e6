// Paths into jobs.

import { describe, expect, it } from "vitest";
import { parsePath, pathText, startsWith, valueAt, withValue } from "../src/lib/path";

const TREE = {
  target: {
    modifications: [
      { kind: "twist", amount_um: 0 },
      { kind: "helix_crowning", amount_um: 20 },
    ],
  },
};

describe("paths", () => {
  it("are written and read as findings write them", () => {
    const path = ["target", "modifications", 1, "amount_um"];
    expect(pathText(path)).toBe("target.modifications[1].amount_um");
    expect(parsePath("target.modifications[1].amount_um")).toEqual(path);
    expect(parsePath("target.modifications.1.amount_um")).toEqual(path);
    expect(startsWith(path, ["target", "modifications"])).toBe(true);
    expect(startsWith(["gear"], ["target"])).toBe(false);
  });
  it("lead to values", () => {
    expect(valueAt(TREE, ["target", "modifications", 1, "amount_um"])).toBe(20);
    expect(valueAt(TREE, ["target", "missing", "deeper"])).toBeUndefined();
  });
});

describe("withValue", () => {
  it("changes a copy", () => {
    const changed = withValue(TREE, ["target", "modifications", 1, "amount_um"], 12.5);
    expect(valueAt(changed, ["target", "modifications", 1, "amount_um"])).toBe(12.5);
    expect(TREE.target.modifications[1]!.amount_um).toBe(20);
  });
  it("makes tables on the way, adds to lists and takes entries out", () => {
    expect(withValue({}, ["grinding", "diagonal_ratio"], -1.9)).toEqual({ grinding: { diagonal_ratio: -1.9 } });
    expect(withValue({ list: [1] }, ["list", 1], 2)).toEqual({ list: [1, 2] });
    expect(withValue({ list: [1, 2] }, ["list", 0], undefined)).toEqual({ list: [2] });
    expect(withValue({ a: 1, b: 2 }, ["a"], undefined)).toEqual({ b: 2 });
  });
});
