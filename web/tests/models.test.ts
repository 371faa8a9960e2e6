// Smaller models: sliders, studies, trends, frames, options, programs, bodies.

import { describe, expect, it } from "vitest";
import { columnsOf, entryForJob } from "../src/catalogue/model";
import { decades, studyOf, ticks } from "../src/explore/model";
import { isBeyond, linesOf, placesOf, rangeOf } from "../src/history/model";
import { optionsOf, START } from "../src/inspect/options";
import { keyAsWords, unitOfKey } from "../src/lib/units";
import { asksFor, ratioOf, slidersOf } from "../src/plan/sliders";
import { blend, frameAt } from "../src/process/frames";
import { axisOfChart, firstLines, type Program } from "../src/programs/model";
import type { TrendPoint } from "../src/api/types";
import type { Table } from "../src/lib/path";

describe("sliders", () => {
  const tree: Table = {
    job: { process: "generating-grinding" },
    target: {
      modifications: [
        { kind: "twist", amount_um: -6 },
        { kind: "formula", f_um: "u" },
      ],
    },
    grinding: { method: "diagonal" },
  };
  it("move amounts, with room on both sides", () => {
    const sliders = slidersOf(tree);
    expect(sliders).toHaveLength(1);
    expect(sliders[0]).toMatchObject({
      path: ["target", "modifications", 0, "amount_um"],
      key: "twist",
      flank: "both",
      value: -6,
      most: 20,
    });
    expect(asksFor(tree, "twist")).toBe(true);
    expect(asksFor(tree, "helix_crowning")).toBe(false);
  });
  it("move the ratio where a job has one", () => {
    expect(ratioOf(tree)).toEqual({ path: ["grinding", "diagonal_ratio"], value: undefined });
    expect(ratioOf({ grinding: { method: "radial" } })).toBeUndefined();
    expect(ratioOf({ job: { process: "tangential-dressing" }, grinding: { shift_ratio: "width" } })?.path).toEqual([
      "grinding",
      "shift_ratio",
    ]);
  });
  it("move edge amounts of each flank", () => {
    const sliders = slidersOf({ target: { edge_amounts: { left: { lead_crowning_um: 10 }, right: { lead_crowning_um: 60 } } } });
    expect(sliders.map((slider) => [slider.flank, slider.most])).toEqual([
      ["left", 50],
      ["right", 200],
    ]);
  });
});

describe("units", () => {
  it("follow from keys", () => {
    expect(unitOfKey("cutting_speed_m_per_s")).toBe("m/s");
    expect(unitOfKey("flank_um_per_rad")).toBe("µm/rad");
    expect(unitOfKey("tip_diameter")).toBe("mm");
    expect(unitOfKey("teeth")).toBe("");
    expect(unitOfKey("profile_shift")).toBe("");
    expect(unitOfKey("helix_crowning_um")).toBe("µm");
    expect(keyAsWords("max_deviation_um")).toBe("Max deviation");
    expect(["fHa_um", "z_start", "v_zS_mm", "gA", "w"].map(keyAsWords)).toEqual(["fHa", "z start", "v zS", "gA", "w"]);
  });
});

describe("studies", () => {
  it("have candidates with what varies", () => {
    const study = studyOf({
      varied: ["diagonal_ratio"],
      tolerance_um: 1,
      candidates: [
        { rank: 1, diagonal_ratio: -1.9, allowed: true, residual_um: 0.003 },
        { rank: 2, diagonal_ratio: 1, refused: { code: "worm-too-short" } },
      ],
    });
    expect(study.candidates[0]!.at).toEqual({ diagonal_ratio: -1.9 });
    expect(study.candidates[1]).toMatchObject({ allowed: false, refused: "worm-too-short", residual: undefined });
  });
  it("lie on round scales", () => {
    expect(decades([0.003, 12])).toEqual({ low: -3, high: 2 });
    expect(decades([])).toEqual({ low: -3, high: 1 });
    expect(ticks(-3, 3, 6)).toEqual([-3, -2, -1, 0, 1, 2, 3]);
  });
});

describe("trends", () => {
  const point = (digest: string, date: string, value: number, flank: TrendPoint["flank"] = "left"): TrendPoint => ({
    digest,
    part: digest,
    date,
    name: "fHb",
    flank,
    tooth: null,
    statistic: "mean",
    value,
    unit: "um",
    lower_limit: -6,
    upper_limit: 6,
  });
  const points = [point("b", "2026-02-01", 7), point("a", "2026-01-01", 1), point("a", "2026-01-01", -2, "right")];
  it("order parts by their date and find what is beyond its limit", () => {
    const lines = linesOf(points, "mean");
    expect(lines.map((line) => line.flank)).toEqual(["left", "right"]);
    expect(placesOf(lines)).toEqual(["a", "b"]);
    expect(points.filter(isBeyond).map((some) => some.digest)).toEqual(["b"]);
    const [low, high] = rangeOf(lines);
    expect(low).toBeLessThan(-6);
    expect(high).toBeGreaterThan(7);
  });
});

describe("frames", () => {
  const still = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
  const turned = [0, -1, 0, 1, 0, 0, 0, 0, 1, 10, 0, 0];
  it("are blended between: half the turn, half the way", () => {
    const pose = blend(still, turned, 0.5);
    expect(pose[0]).toBeCloseTo(Math.SQRT1_2, 12);
    expect(pose[3]).toBeCloseTo(Math.SQRT1_2, 12);
    expect(pose[9]).toBe(5);
    blend(still, turned, 1).forEach((value, at) => expect(value).toBeCloseTo(turned[at]!, 12));
  });
  it("turn half a revolution without falling apart", () => {
    const half = [-1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0];
    const pose = blend(still, half, 0.5);
    expect(pose[0]! ** 2 + pose[3]! ** 2).toBeCloseTo(1, 12);
  });
  it("hold at the ends", () => {
    const frames = [
      { at: 0, poses: { worm: still }, contact: [] },
      { at: 1, poses: { worm: turned }, contact: [] },
    ];
    expect(frameAt(frames, -5)!.poses["worm"]).toEqual(still);
    expect(frameAt(frames, 5)!.poses["worm"]).toEqual(turned);
    expect(frameAt([], 0)).toBeUndefined();
  });
});

describe("options of an inspection", () => {
  it("hold only what is stated", () => {
    expect(optionsOf(START, true, "de")).toEqual({});
    // Without a job nothing else says in which language the report is.
    expect(optionsOf(START, false, "de")).toEqual({ language: "de" });
    // Stock is that over the gear of a job, and judged by no class.
    expect(optionsOf({ ...START, blank: true, toleranceClass: 6 }, true, "en")).toEqual({ blank: true });
    expect(optionsOf({ ...START, blank: true }, false, "en")).toEqual({ language: "en" });
    expect(optionsOf({ ...START, slopeSigns: "din", toleranceClass: 6, series: "x" }, true, "en")).toEqual({
      slope_signs: { left: 1, right: -1 },
      class: 6,
    });
    expect(optionsOf({ ...START, keep: true, series: " ring " }, true, "en")).toEqual({ keep: true, series: "ring" });
  });
});

describe("catalogue and programs", () => {
  it("lay nested entries out as columns and back into a job", () => {
    const dresser = { name: "D1", tip_diameter: 120, designed_for: { threads: 3 }, flank_diameters: { from: 1, to: 2 } };
    expect(columnsOf([dresser])).toEqual([
      "name",
      "tip_diameter",
      "designed_for.threads",
      "flank_diameters.from",
      "flank_diameters.to",
    ]);
    expect(entryForJob("dresser", dresser)).toEqual({ tip_diameter: 120, designed_for: { threads: 3 }, modification: "none" });
  });
  it("find the axis of a chart by its title", () => {
    const axis = (name: string, from: number) => ({ axis: name, unit: "mm", from, to: from + 1, way: 2 });
    const program = (does: string, from: number) => ({ does, axes: [axis("X1", from), axis("Z1", 0)] }) as unknown as Program;
    const programs = [program("dressing", -5), program("grinding", -9)];
    expect(axisOfChart("Grinding: Axis X1, word X", programs)?.from).toBe(-9);
    expect(axisOfChart("Axis Z1, word Z", programs)?.axis).toBe("Z1");
    expect(axisOfChart("Grinding: Axis C2, word C", programs)).toBeUndefined();
    expect(axisOfChart("Axes over time: all paths", programs)).toBeUndefined();
  });
  it("show the first lines of a text", () => {
    expect(firstLines("a\nb\nc", 2)).toEqual({ lines: "a\nb", isWhole: false });
    expect(firstLines("a\nb", 2)).toEqual({ lines: "a\nb", isWhole: true });
  });
});
