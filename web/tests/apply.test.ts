// A combination of a study belongs to the job that was studied.

import { describe, expect, it } from "vitest";
import { editsOf, isStudiedJob } from "../src/explore/apply";
import { studyOf } from "../src/explore/model";

const studied = {
  job: { name: "twist-free", process: "generating-grinding", description: "words" },
  gear: { teeth: 19, normal_module: 3 },
  worm: { pitch_diameter: 240, tip_diameter: 246, hand: "right" },
  grinding: { method: "diagonal" },
  explore: { diagonal_ratio: { from: -3, to: 3, count: 41 } },
};
const study = studyOf({
  varied: ["worm_cone_angle_deg", "crossed_axes_angle_deg", "diagonal_ratio"],
  candidates: [
    {
      rank: 1,
      worm_cone_angle_deg: 3,
      crossed_axes_angle_deg: 88,
      worm_pitch_diameter_mm: 250.5,
      diagonal_ratio: -0.670102744,
      allowed: true,
    },
    { rank: 2, worm_cone_angle_deg: 3, crossed_axes_angle_deg: 88, diagonal_ratio: 1, refused: { code: "x", text: "too long" } },
    { rank: 3, worm_cone_angle_deg: 3, crossed_axes_angle_deg: 88, diagonal_ratio: null, allowed: true },
  ],
});

describe("a combination", () => {
  it("is taken with everything that was varied; the addendum of the worm stays", () => {
    expect(editsOf(study, study.candidates[0], studied)).toEqual([
      { path: ["worm", "cone_angle_deg"], value: 3 },
      { path: ["worm", "pitch_diameter"], value: 250.5 },
      { path: ["worm", "tip_diameter"], value: 256.5 },
      { path: ["grinding", "diagonal_ratio"], value: -0.670102744 },
    ]);
  });
  it("is not taken where it is refused or lacks a value", () => {
    expect(editsOf(study, study.candidates[1], studied)).toBeUndefined();
    expect(editsOf(study, study.candidates[2], studied)).toBeUndefined();
    expect(editsOf(study, undefined, studied)).toBeUndefined();
  });
});

describe("the studied job", () => {
  const files = { "map.csv": "1" };
  const varied = ["diagonal_ratio"];
  const { explore: _, ...withoutExplore } = studied;
  const is = (tree: typeof studied | object, own = files): boolean =>
    isStudiedJob({ tree: tree as typeof studied, files: own }, { tree: studied, files }, varied);
  it("is known by its content, in any order, with another value of what was varied", () => {
    expect(is(Object.fromEntries(Object.entries(studied).reverse()))).toBe(true);
    expect(is({ ...studied, grinding: { method: "diagonal", diagonal_ratio: -0.67 } })).toBe(true);
    expect(is({ ...withoutExplore, job: { ...studied.job, description: "other words" } })).toBe(true);
  });
  it("is no other job, of the same name or not", () => {
    expect(is({ ...studied, job: { ...studied.job, name: "automotive-bias" } })).toBe(false);
    expect(is({ ...studied, gear: { teeth: 20, normal_module: 3 } })).toBe(false);
    expect(is({ ...studied, worm: { ...studied.worm, cone_angle_deg: 1 } })).toBe(false);
    expect(is(studied, { "map.csv": "2" })).toBe(false);
  });
});
