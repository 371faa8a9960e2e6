// Colours of signed values, the same as in the charts of reports: white to blue for relief, white to ochre for material left.
// Lightness falls with the magnitude on both sides, so that the order survives a grey copy and any colour vision.

type Rgb = [number, number, number];

const RELIEF: Rgb[] = [
  [250, 250, 248],
  [205, 222, 236],
  [146, 182, 212],
  [84, 135, 182],
  [38, 84, 136],
];
const MATERIAL: Rgb[] = [
  [250, 250, 248],
  [247, 223, 190],
  [233, 178, 118],
  [203, 126, 61],
  [147, 78, 22],
];

/** Colour of a signed value, `share` = value / largest magnitude in -1 .. 1, channels from 0 to 255. */
export function signedRgb(share: number): Rgb {
  const stops = share < 0 ? RELIEF : MATERIAL;
  const place = Math.min(Math.abs(share) || 0, 1) * (stops.length - 1);
  const below = Math.min(Math.floor(place), stops.length - 2);
  const part = place - below;
  const low = stops[below]!;
  const high = stops[below + 1]!;
  return [0, 1, 2].map((channel) => Math.round(low[channel]! + (high[channel]! - low[channel]!) * part)) as Rgb;
}

export function signedColour(share: number): string {
  return `rgb(${signedRgb(share).join(" ")})`;
}

/** The largest magnitude in grids of values, at least `least`; holes (not finite) do not count. */
export function largestMagnitude(grids: number[][][], least = 1e-9): number {
  let most = least;
  for (const grid of grids) for (const row of grid) for (const value of row) if (Math.abs(value) > most) most = Math.abs(value);
  return most;
}

/** Steps of 1, 2 or 5 times a power of ten, about `wanted` of them on one side of zero. */
export function levelStep(most: number, wanted = 5): number {
  const raw = most / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  const share = raw / power;
  return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}

/** Levels of isolines from -most to most. */
export function levels(most: number, wanted = 5): number[] {
  const step = levelStep(most, wanted);
  const count = Math.floor(most / step + 1e-9);
  return Array.from({ length: 2 * count + 1 }, (_, k) => Number(((k - count) * step).toPrecision(12)));
}
