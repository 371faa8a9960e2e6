// What the axes of a flank are called: in full beside maps, by their symbols in the net.

import type { Texts } from "../texts/en";

export interface AxisLabels {
  profile: string;
  helix: string;
}

export function axisLabels(isInvolute: boolean, isShort: boolean, texts: Texts): AxisLabels {
  const { profile, helix, height, length } = texts.plan;
  if (isInvolute)
    return isShort ? { profile: "w [mm]", helix: "z [mm]" } : { profile: `${profile} [mm]`, helix: `${helix} [mm]` };
  return { profile: `${height} [mm]`, helix: `${length} [mm]` };
}
