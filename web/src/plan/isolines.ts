// Isolines of a map as paths, and places for their labels that do not cover each other.

import { isolineSegments, joinSegments, type Point } from "../lib/contours";

export type Share = [x: number, y: number];

export interface Isoline {
  level: number;
  path: string;
  label: Share | undefined;
}

/** More pieces than this have no room between them: the ground colours tell more alone. */
const MOST_PIECES = 90;
/** Room that a label takes, as shares of the map. */
const LABEL = { width: 0.075, height: 0.085 };
/** Where along a line its label may stand, best first. */
const PLACES = [0.5, 0.32, 0.68, 0.18, 0.82];

/** The isolines of a grid; `share` turns places of the grid into shares of the map, from the upper left. */
export function drawnIsolines(grid: number[][], levels: number[], share: (point: Point) => Share): Isoline[] {
  const pieces = levels.map((level) => ({
    level,
    lines: joinSegments(isolineSegments(grid, level)).map((line) => line.map(share)),
  }));
  if (pieces.reduce((sum, piece) => sum + piece.lines.length, 0) > MOST_PIECES) return [];
  const taken: Share[] = [];
  return pieces.map(({ level, lines }) => {
    const label = placeOf(lines, taken);
    if (label) taken.push(label);
    return { level, path: lines.map(pathOf).join(""), label };
  });
}

function pathOf(line: Share[]): string {
  return `M${line.map(([x, y]) => `${(x * 100).toFixed(2)} ${(y * 100).toFixed(2)}`).join("L")}`;
}

/** A place on the longest lines that is inside the map and free. */
function placeOf(lines: Share[][], taken: Share[]): Share | undefined {
  const long = lines.filter((line) => line.length > 3).sort((a, b) => b.length - a.length);
  for (const line of long.slice(0, 3)) {
    for (const place of PLACES) {
      const [x, y] = line[Math.floor(place * (line.length - 1))]!;
      const inside: Share = [Math.min(0.96, Math.max(0.04, x)), Math.min(0.95, Math.max(0.05, y))];
      const isFree = taken.every(([a, b]) => Math.abs(a - inside[0]) > LABEL.width || Math.abs(b - inside[1]) > LABEL.height);
      if (isFree) return inside;
    }
  }
  return undefined;
}
