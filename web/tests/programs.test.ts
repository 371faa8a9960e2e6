// Marks of programs and of axes near their limits.

import { describe, expect, it } from "vitest";
import { verdictOf } from "../src/api/verdict";
import { markOf, nearnessOf, programsOf, travelNearness } from "../src/programs/model";
import type { ResultDocument, Run } from "../src/api/types";

const run = (document: ResultDocument): Run => ({
  id: 1,
  kind: "plan",
  name: "job",
  state: "done",
  created: "",
  measurements: [],
  files: [{ name: "programs/job-grinding-siemens.mpf", bytes: 1 }],
  charts: [],
  scene: false,
  document,
});
const proofs = [
  {
    controls: ["siemens", "fanuc"],
    statement: "proven from the program text: max deviation 13.4609 um",
    flanks: { left: { max_deviation_um: 13.4609 }, right: { max_deviation_um: 9 } },
  },
];
const entry = { file: "programs/job-grinding-siemens.mpf", control: "siemens", job: "grinding" };
const mark = (document: ResultDocument): string => markOf(programsOf(run(document))[0]!, verdictOf(document));

describe("the mark of a program", () => {
  it("is that of the run: a proven text of a missed target is missed", () => {
    const programs = { programs: [entry], proofs };
    expect(mark({ status: "missed", tolerance_um: 1, programs })).toBe("missed");
    expect(mark({ status: "not_judged", programs })).toBe("not_judged");
    expect(mark({ status: "met", programs })).toBe("met");
    expect(mark({ programs })).toBe("not_judged");
    expect(programsOf(run({ programs }))[0]!.deviation).toBe(13.4609);
  });
  it("is never met without a proof", () => {
    expect(mark({ status: "met", programs: { programs: [entry], proofs: [] } })).toBe("not_judged");
  });
  it("is missed where the text is not what was planned", () => {
    const of = (difference: number) => ({ ...entry, proof_difference_um: difference, proof_allowed_um: 0.2 });
    expect(mark({ status: "met", programs: [of(0.1)] })).toBe("met");
    expect(mark({ status: "met", programs: [of(0.3)] })).toBe("missed");
  });
});

describe("axes", () => {
  it("are marked near, at and beyond a limit", () => {
    expect([0.5, 0.949, 0.95, 0.9994, 1, 1.0004, 1.01, undefined].map(nearnessOf)).toEqual([
      undefined,
      undefined,
      "near",
      "near",
      "at",
      "at",
      "over",
      undefined,
    ]);
  });
  it("are marked by the nearer end of their travel, however little of it they use", () => {
    const axis = (from: number, to: number) => ({ axis: "X", unit: "mm", from, to, way: 1, min: -100, max: 100 });
    expect(travelNearness(axis(-10, 10))).toBeUndefined();
    expect(travelNearness(axis(96, 97))).toBe("near");
    expect(travelNearness(axis(-100, 0))).toBe("at");
    expect(travelNearness(axis(0, 101))).toBe("over");
    expect(travelNearness({ axis: "X", unit: "mm", from: 0, to: 1e9, way: 1 })).toBeUndefined();
  });
});
