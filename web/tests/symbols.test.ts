// Symbols of characteristics, and the marks of scales.

import { expect, it } from "vitest";
import { decimalsOf, ticks } from "../src/explore/model";
import { symbolOf } from "../src/lib/symbols";

it("writes profile and helix by their Greek letters and leaves other names alone", () => {
  expect(["fHa", "ffa", "Fa", "Ca", "fHb", "ffb", "Fb", "Cb"].map(symbolOf).join(" ")).toBe("fHα ffα Fα Cα fHβ ffβ Fβ Cβ");
  expect(["fp", "Fp", "S", "x-span", "fHm", "Fba"].map(symbolOf)).toEqual(["fp", "Fp", "S", "x-span", "fHm", "Fba"]);
});

it("gives all marks of a scale the same decimals", () => {
  expect(decimalsOf(ticks(-0.28, 0))).toBe(2);
  expect(decimalsOf(ticks(-0.3, 0.3))).toBe(1);
  expect(decimalsOf(ticks(0, 12))).toBe(0);
  expect(decimalsOf([])).toBe(0);
});
