// Names and units of the axes of flanks, as their documents state them.

import { describe, expect, it } from "vitest";
import { pairsOf } from "../src/compare/model";
import { axisLabels } from "../src/plan/labels";
import { flanksOfDocument } from "../src/plan/surfaces";
import { de } from "../src/texts/de";
import { en } from "../src/texts/en";

const flank = (height_unit: string, length_unit: string) => ({
  height_unit,
  length_unit,
  height: [0.1, 0.2],
  length: [1, 2],
  planned_um: [1, 2, 3, 4],
});
const field = (height: string, length: string) => flanksOfDocument({ flanks: { left: flank(height, length) } }).left;

describe("axes of a flank", () => {
  it("have the units of the document", () => {
    expect(axisLabels(field("rad", "mm"), false, en)).toMatchObject({
      profile: "Roll angle [rad]",
      helix: "Distance from the apex [mm]",
    });
    expect(axisLabels(field("1", "1"), false, en)).toMatchObject({ profile: "Height, hub to tip", helix: "Along the blade" });
    expect(axisLabels(field("mm", "mm"), false, en)).toMatchObject({
      profile: "Length of roll w [mm]",
      helix: "Face position z [mm]",
    });
    expect(axisLabels(field("mm", "mm"), true, en)).toMatchObject({ profile: "w [mm]", helix: "z [mm]" });
    expect(axisLabels(field("rad", "mm"), false, de).profile).toBe("Wälzwinkel [rad]");
  });
  it("tell a place by the same names and units", () => {
    const { profile, helix } = axisLabels(field("rad", "mm"), false, en).coordinates;
    expect([profile.short, profile.unit, helix.short, helix.unit]).toEqual(["Roll angle", "rad", "Distance from the apex", "mm"]);
    const roll = axisLabels(
      flanksOfDocument({
        flanks: {
          left: {
            w_mm: [1, 2],
            z_mm: [1, 2],
            target_um: [
              [0, 0],
              [0, 0],
            ],
          },
        },
      }).left,
      false,
      en,
    ).coordinates;
    expect([roll.profile.short, roll.profile.unit, roll.helix.short, roll.helix.unit]).toEqual(["w", "mm", "z", "mm"]);
  });
  it("in other units are not compared place by place", () => {
    const a = flanksOfDocument({ flanks: { left: flank("rad", "mm") } });
    const b = flanksOfDocument({ flanks: { left: flank("mm", "mm") } });
    expect(pairsOf(a, b, "planned", undefined)).toEqual([]);
    expect(pairsOf(a, a, "planned", undefined)).toHaveLength(1);
  });
});
