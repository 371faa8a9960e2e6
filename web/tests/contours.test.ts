// Isolines and values between the points of a grid.

import { describe, expect, it } from "vitest";
import { fractionalIndex, isolineSegments, joinSegments, valueInGrid } from "../src/lib/contours";
import { drawnIsolines } from "../src/plan/isolines";

/** Value x + 10 y over 5 columns and 4 rows. */
const PLANE = Array.from({ length: 4 }, (_, row) => Array.from({ length: 5 }, (_, column) => column + 10 * row));
/** A bump with its top in the middle. */
const BUMP = Array.from({ length: 9 }, (_, row) =>
  Array.from({ length: 9 }, (_, column) => -((row - 4) ** 2) - (column - 4) ** 2),
);

describe("isolines", () => {
  it("stand where a bilinear plane has the level", () => {
    const points = isolineSegments(PLANE, 12.5).flat();
    expect(points.length).toBeGreaterThan(0);
    for (const [column, row] of points) expect(valueInGrid(PLANE, row, column)).toBeCloseTo(12.5, 9);
  });
  it("close around a bump as one line", () => {
    const lines = joinSegments(isolineSegments(BUMP, -4.5));
    expect(lines).toHaveLength(1);
    const [first, last] = [lines[0]![0]!, lines[0]!.at(-1)!];
    expect(Math.hypot(first[0] - last[0], first[1] - last[1])).toBeLessThan(1e-6);
  });
  it("leave holes out", () => {
    expect(
      isolineSegments(
        [
          [0, 1],
          [NaN, 1],
        ],
        0.5,
      ),
    ).toEqual([]);
  });
  it("have labels apart from each other", () => {
    const lines = drawnIsolines(BUMP, [-16.5, -9.5, -4.5], ([x, y]) => [x / 8, y / 8]);
    const labels = lines.flatMap((line) => (line.label ? [line.label] : []));
    expect(labels.length).toBeGreaterThan(1);
    for (const [at, a] of labels.entries()) {
      for (const b of labels.slice(at + 1)) expect(Math.abs(a[0] - b[0]) > 0.07 || Math.abs(a[1] - b[1]) > 0.08).toBe(true);
    }
  });
});

describe("values between points", () => {
  it("are bilinear and clamped to the grid", () => {
    expect(valueInGrid(PLANE, 1.5, 2.25)).toBeCloseTo(17.25, 12);
    expect(fractionalIndex([0, 2, 10], 6)).toBeCloseTo(1.5, 12);
    expect(fractionalIndex([0, 2, 10], -5)).toBe(0);
    expect(fractionalIndex([0, 2, 10], 99)).toBe(2);
  });
});
