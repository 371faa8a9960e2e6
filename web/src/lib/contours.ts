// Isolines of a grid of values by marching squares, in index coordinates: column over the helix, row over the profile.

export type Point = [column: number, row: number];

/** The pieces of the line on which the grid, taken as bilinear, has the value `level`. */
export function isolineSegments(grid: number[][], level: number): [Point, Point][] {
  const segments: [Point, Point][] = [];
  for (let row = 0; row + 1 < grid.length; row++) {
    const low = grid[row]!;
    const high = grid[row + 1]!;
    for (let column = 0; column + 1 < low.length; column++) {
      const corners = [low[column]!, low[column + 1]!, high[column + 1]!, high[column]!].map((value) => value - level);
      if (!corners.every(Number.isFinite)) continue;
      const places: Point[] = [
        [column, row],
        [column + 1, row],
        [column + 1, row + 1],
        [column, row + 1],
      ];
      const crossings: Point[] = [];
      for (let side = 0; side < 4; side++) {
        const next = (side + 1) % 4;
        const [a, b] = [corners[side]!, corners[next]!];
        if (a >= 0 === b >= 0) continue;
        const part = a / (a - b);
        const [from, to] = [places[side]!, places[next]!];
        crossings.push([from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]);
      }
      if (crossings.length === 2) segments.push([crossings[0]!, crossings[1]!]);
      else if (crossings.length === 4) {
        // A saddle: the value in the middle tells which corners belong together.
        const middleIsHigh = corners[0]! + corners[1]! + corners[2]! + corners[3]! >= 0;
        const apart = corners[0]! >= 0 === middleIsHigh;
        segments.push([crossings[0]!, crossings[apart ? 1 : 3]!], [crossings[2]!, crossings[apart ? 3 : 1]!]);
      }
    }
  }
  return segments;
}

/** Segments joined into lines, as far as their ends meet. */
export function joinSegments(segments: [Point, Point][]): Point[][] {
  const key = (point: Point): string => `${point[0].toFixed(6)},${point[1].toFixed(6)}`;
  const ends = new Map<string, number[]>();
  segments.forEach((segment, at) => segment.forEach((point) => ends.set(key(point), [...(ends.get(key(point)) ?? []), at])));
  const used = new Set<number>();
  const lines: Point[][] = [];
  segments.forEach((segment, start) => {
    if (used.has(start)) return;
    used.add(start);
    const line: Point[] = [...segment];
    for (const forward of [true, false]) {
      for (;;) {
        const end = forward ? line[line.length - 1]! : line[0]!;
        const next = ends.get(key(end))?.find((at) => !used.has(at));
        if (next === undefined) break;
        used.add(next);
        const [a, b] = segments[next]!;
        const far = key(a) === key(end) ? b : a;
        if (forward) line.push(far);
        else line.unshift(far);
      }
    }
    lines.push(line);
  });
  return lines;
}

/** The place of a value in an ascending list of coordinates as a fractional index, clamped to the list. */
export function fractionalIndex(coordinates: number[], value: number): number {
  const last = coordinates.length - 1;
  if (last < 1 || value <= coordinates[0]!) return 0;
  if (value >= coordinates[last]!) return last;
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (coordinates[middle]! <= value) low = middle;
    else high = middle;
  }
  return low + (value - coordinates[low]!) / (coordinates[high]! - coordinates[low]!);
}

/** Bilinear value of a grid at fractional indices. */
export function valueInGrid(grid: number[][], row: number, column: number): number {
  const r = Math.min(Math.floor(row), grid.length - 2);
  const c = Math.min(Math.floor(column), (grid[0]?.length ?? 0) - 2);
  if (r < 0 || c < 0) return grid[Math.max(0, Math.round(row))]?.[Math.max(0, Math.round(column))] ?? NaN;
  const [dr, dc] = [row - r, column - c];
  const at = (i: number, j: number): number => grid[i]?.[j] ?? NaN;
  return (1 - dr) * ((1 - dc) * at(r, c) + dc * at(r, c + 1)) + dr * ((1 - dc) * at(r + 1, c) + dc * at(r + 1, c + 1));
}
