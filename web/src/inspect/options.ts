// What the user states about measurements, and the options of the request that it becomes. What is left as it is is not sent.

import type { InspectOptions } from "../api/types";

export interface Stated {
  fromOtherEnd: boolean;
  slopeSigns: "" | "material" | "din" | "--" | "-+";
  datumFace: "" | "+z" | "-z";
  toleranceClass: number | "";
  helixSlopeOver: "" | "face-width" | "range";
  profileSlopeOver: "" | "face-width" | "range";
  keep: boolean;
  series: string;
}

export const START: Stated = {
  fromOtherEnd: false,
  slopeSigns: "",
  datumFace: "",
  toleranceClass: "",
  helixSlopeOver: "",
  profileSlopeOver: "",
  keep: false,
  series: "",
};

/** Signs of the left and the right flank. */
const SIGNS = { material: [1, 1], din: [1, -1], "--": [-1, -1], "-+": [-1, 1] } as const;

export function optionsOf(stated: Stated): InspectOptions {
  const options: InspectOptions = {};
  if (stated.fromOtherEnd) options.from_other_end = true;
  if (stated.slopeSigns !== "") {
    const [left, right] = SIGNS[stated.slopeSigns];
    options.slope_signs = { left, right };
  }
  if (stated.datumFace !== "") options.datum_face = stated.datumFace;
  if (stated.toleranceClass !== "") options.class = stated.toleranceClass;
  if (stated.helixSlopeOver !== "") options.helix_slope_over = stated.helixSlopeOver;
  if (stated.profileSlopeOver !== "") options.profile_slope_over = stated.profileSlopeOver;
  if (stated.keep) {
    options.keep = true;
    if (stated.series.trim() !== "") options.series = stated.series.trim();
  }
  return options;
}
