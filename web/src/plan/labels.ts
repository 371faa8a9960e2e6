// What the axes of a flank are called, by the units that its document states: in full beside maps, short in the net and beside values.

import { shownUnit } from "../lib/units";
import type { Texts } from "../texts/en";
import type { FlankField } from "./surfaces";

/** One coordinate of a flank: its name beside an axis, its name beside a value, its unit and the decimals of its values. */
export interface Coordinate {
  title: string;
  short: string;
  unit: string;
  decimals: number;
}

export interface AxisLabels {
  profile: string;
  helix: string;
  /** How a place is told. */
  coordinates: { profile: Coordinate; helix: Coordinate };
}

const DECIMALS: Record<string, number> = { mm: 2, rad: 4, "°": 3, "": 3 };

/** Names by the units: length of roll and face position, roll angle and distance from the apex, or fractions of a blade. */
export function axisLabels(field: FlankField | undefined, isShort: boolean, texts: Texts): AxisLabels {
  const { height, length } = field?.units ?? { height: "mm", length: "mm" };
  const t = texts.plan;
  const [profile, helix] =
    height === "mm"
      ? [coordinate(t.profile, "w", height), coordinate(t.helix, "z", length)]
      : height === "rad"
        ? [coordinate(t.rollAngle, t.rollAngle, height), coordinate(t.apexDistance, t.apexDistance, length)]
        : [coordinate(t.height, t.height, height), coordinate(t.length, t.length, length)];
  const title = (of: Coordinate): string => {
    const name = isShort ? of.short : of.title;
    return of.unit === "" ? name : `${name} [${of.unit}]`;
  };
  return { profile: title(profile), helix: title(helix), coordinates: { profile, helix } };
}

function coordinate(title: string, short: string, unit: string): Coordinate {
  const shown = shownUnit(unit);
  return { title, short, unit: shown, decimals: DECIMALS[shown] ?? 3 };
}
