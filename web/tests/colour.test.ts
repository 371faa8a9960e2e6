// The scale of colours and the levels of isolines.

import { describe, expect, it } from "vitest";
import { largestMagnitude, levels, levelStep, signedRgb } from "../src/lib/colour";

const luminance = ([r, g, b]: number[]): number => 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;

describe("signedRgb", () => {
  it("gets darker with the magnitude on both sides, and ends where it ends", () => {
    for (const sign of [-1, 1]) {
      const light = Array.from({ length: 41 }, (_, k) => luminance(signedRgb((sign * k) / 40)));
      expect(light.every((value, k) => k === 0 || value < light[k - 1]!)).toBe(true);
    }
    expect(signedRgb(5)).toEqual(signedRgb(1));
    expect(signedRgb(0)).toEqual([250, 250, 248]);
  });
  it("is blue below and ochre above zero", () => {
    expect(signedRgb(-1)).toEqual([38, 84, 136]);
    expect(signedRgb(1)).toEqual([147, 78, 22]);
  });
});

describe("levels", () => {
  it("are round and lie on both sides of zero", () => {
    expect(levels(20.9)).toEqual([-20, -15, -10, -5, 0, 5, 10, 15, 20]);
    expect(levelStep(0.0036)).toBe(0.0005);
    expect(levels(1)).toContain(0);
  });
  it("cover what is there", () => {
    expect(largestMagnitude([[[1, -3]], [[NaN, 2]]])).toBe(3);
    expect(largestMagnitude([])).toBeGreaterThan(0);
  });
});
