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
});

describe("labels of isolines", () => {
  const share = ([x, y]: [number, number]): [number, number] => [x / 8, y / 8];
  const LEVELS = [-16.5, -9.5, -4.5];
  const labelled = (room: { width: number; height: number }) =>
    drawnIsolines(BUMP, LEVELS, share, room).flatMap((line) => (line.label ? [line.label] : []));
  it("are apart from each other and inside the map", () => {
    const labels = labelled({ width: 0.1, height: 0.08 });
    expect(labels).toHaveLength(3);
    for (const [at, a] of labels.entries()) {
      for (const b of labels.slice(at + 1)) expect(Math.abs(a[0] - b[0]) > 0.1 || Math.abs(a[1] - b[1]) > 0.08).toBe(true);
      expect(Math.min(a[0], 1 - a[0])).toBeGreaterThanOrEqual(0.05);
      expect(Math.min(a[1], 1 - a[1])).toBeGreaterThanOrEqual(0.04);
    }
  });
  it("hide no line of another level", () => {
    const dense = Array.from({ length: 15 }, (_, at) => -16.5 + at / 10);
    const room = { width: 0.1, height: 0.08 };
    expect(drawnIsolines(BUMP, dense, share, room).filter((line) => line.label).length).toBeLessThan(5);
  });
  it("are left out where the map is small", () => {
    expect(labelled({ width: 0.4, height: 0.2 })).toEqual([]);
    expect(drawnIsolines(BUMP, LEVELS, share, { width: 0.4, height: 0.2 })).toHaveLength(3);
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
