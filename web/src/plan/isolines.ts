// Isolines of a map as paths, and places for their labels that do not cover each other.

import { isolineSegments, joinSegments, type Point } from "../lib/contours";

export type Share = [x: number, y: number];

export interface Isoline {
  level: number;
  path: string;
  label: Share | undefined;
}

/** The room that a label takes, as shares of the map. */
export interface Room {
  width: number;
  height: number;
}

/** More pieces than this have no room between them: the ground colours tell more alone. */
const MOST_PIECES = 90;
/** A map of which a label takes a greater share than this has no room for labels. */
const MOST_ROOM = 0.35;
/** The part of its room that a label's letters fill. */
const PRINTED = 0.7;
/** Where along a line its label may stand, best first. */
const PLACES = [0.5, 0.32, 0.68, 0.18, 0.82];

/** The isolines of a grid; `share` turns places of the grid into shares of the map, from the upper left; `room` is what a label takes. */
export function drawnIsolines(grid: number[][], levels: number[], share: (point: Point) => Share, room: Room): Isoline[] {
  const pieces = levels.map((level) => ({
    level,
    lines: joinSegments(isolineSegments(grid, level)).map((line) => line.map(share)),
  }));
  if (pieces.reduce((sum, piece) => sum + piece.lines.length, 0) > MOST_PIECES) return [];
  const taken: Share[] = [];
  return pieces.map(({ level, lines }, at) => {
    const others = pieces.flatMap((piece, other) => (other === at ? [] : piece.lines));
    const label = placeOf(lines, others, taken, room);
    if (label) taken.push(label);
    return { level, path: lines.map(pathOf).join(""), label };
  });
}

function pathOf(line: Share[]): string {
  return `M${line.map(([x, y]) => `${(x * 100).toFixed(2)} ${(y * 100).toFixed(2)}`).join("L")}`;
}

/** A place on the longest lines that is inside the map, covers no other label, and hides no line of another level. */
function placeOf(lines: Share[][], others: Share[][], taken: Share[], room: Room): Share | undefined {
  if (room.width > MOST_ROOM || room.height > MOST_ROOM) return undefined;
  const within = (place: number, size: number): number => Math.min(1 - size / 2, Math.max(size / 2, place));
  const long = lines.filter((line) => line.length > 3).sort((a, b) => b.length - a.length);
  for (const line of long.slice(0, 3)) {
    for (const place of PLACES) {
      const [x, y] = line[Math.floor(place * (line.length - 1))]!;
      const inside: Share = [within(x, room.width), within(y, room.height)];
      const isFree = taken.every(([a, b]) => Math.abs(a - inside[0]) > room.width || Math.abs(b - inside[1]) > room.height);
      if (isFree && !others.some((other) => crosses(other, inside, room))) return inside;
    }
  }
  return undefined;
}

/** Whether a line goes through the letters of a label at this place. */
function crosses(line: Share[], place: Share, room: Room): boolean {
  const size = [(room.width / 2) * PRINTED, (room.height / 2) * PRINTED] as const;
  return line.slice(1).some((end, at) => {
    const start = line[at]!;
    let [enter, leave] = [0, 1];
    for (const axis of [0, 1] as const) {
      const [from, way] = [start[axis] - place[axis], end[axis] - start[axis]];
      if (way === 0 && Math.abs(from) > size[axis]) return false;
      if (way === 0) continue;
      const sides = [(-size[axis] - from) / way, (size[axis] - from) / way];
      enter = Math.max(enter, Math.min(...sides));
      leave = Math.min(leave, Math.max(...sides));
    }
    return enter < leave;
  });
}
