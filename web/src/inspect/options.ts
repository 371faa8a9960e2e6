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
  /** The gear is a blank before grinding: its stock over the gear of the job is wanted. */
  blank: boolean;
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
  blank: false,
};

/** Signs of the left and the right flank. */
const SIGNS = { material: [1, 1], din: [1, -1], "--": [-1, -1], "-+": [-1, 1] } as const;

/** With a job its report has the job's language, else that of the pages; the stock of a blank needs a job, and has no class. */
export function optionsOf(stated: Stated, hasJob: boolean, lang: "en" | "de"): InspectOptions {
  const options: InspectOptions = {};
  const isBlank = stated.blank && hasJob;
  if (isBlank) options.blank = true;
  if (!hasJob) options.language = lang;
  if (stated.fromOtherEnd) options.from_other_end = true;
  if (stated.slopeSigns !== "") {
    const [left, right] = SIGNS[stated.slopeSigns];
    options.slope_signs = { left, right };
  }
  if (stated.datumFace !== "") options.datum_face = stated.datumFace;
  if (stated.toleranceClass !== "" && !isBlank) options.class = stated.toleranceClass;
  if (stated.helixSlopeOver !== "") options.helix_slope_over = stated.helixSlopeOver;
  if (stated.profileSlopeOver !== "") options.profile_slope_over = stated.profileSlopeOver;
  if (stated.keep) {
    options.keep = true;
    if (stated.series.trim() !== "") options.series = stated.series.trim();
  }
  return options;
}
