// Places in the text of a job.

import { describe, expect, it } from "vitest";
import { atOwnLines, lineOfField, changeBetween, looksLikeJob, namedFiles, rangeOfFinding } from "../src/job/text";
import { parsePath } from "../src/lib/path";

describe("changeBetween", () => {
  it("is the least change", () => {
    expect(changeBetween("amount = 20.0\n", "amount = 21.0\n")).toEqual({ from: 10, to: 11, insert: "1" });
    expect(changeBetween("aa", "aaa")).toEqual({ from: 2, to: 2, insert: "a" });
    expect(changeBetween("same", "same")).toBeUndefined();
  });
});

describe("rangeOfFinding", () => {
  const text = "[gear]\nteeth = 0\n";
  it("takes offsets, else line and column", () => {
    expect(rangeOfFinding(text, { code: "x", message: "", start: 7, end: 16 })).toEqual({ from: 7, to: 16 });
    expect(rangeOfFinding(text, { code: "x", message: "", line: 2, column: 9 })).toEqual({ from: 15, to: 16 });
  });
  it("stays inside the text", () => {
    expect(rangeOfFinding(text, { code: "x", message: "", start: 99, end: 120 })).toEqual({ from: 17, to: 17 });
    expect(rangeOfFinding(text, { code: "x", message: "", line: 40, column: 3 })).toEqual({ from: 17, to: 17 });
  });
  it("does not point into the job for findings in other files", () => {
    expect(rangeOfFinding(text, { code: "x", message: "", file: "a.csv", line: 2 })).toEqual({ from: 0, to: 0 });
  });
});

describe("files", () => {
  it("are told apart", () => {
    expect(looksLikeJob("job.toml", "# a\n[job]\nname = 'x'")).toBe(true);
    expect(looksLikeJob("machine.toml", "name = 'm'\n[[axis]]")).toBe(false);
    expect(looksLikeJob("corrected-job.json", '{"job": {}}')).toBe(true);
    expect(looksLikeJob("table.csv", "[job]")).toBe(false);
  });
  it("that a job names lie beside it", () => {
    const tree = { target: { file: "grid.csv" }, machine: { file: "machines/eight-axis.toml" }, a: [{ file: "b.csv" }] };
    expect(namedFiles(tree)).toEqual(["grid.csv", "b.csv"]);
  });
});

describe("the line of an entry in the user's text", () => {
  const text = [
    "# a job",
    "[job]",
    'name = "a"',
    "",
    "[gear]",
    "teeth = 19 # teeth",
    "evaluation.start_diameter = 60",
    "[target]",
    "[[target.modifications]]",
    'kind = "twist"',
    "amount_um = 1",
    "",
    "[[target.modifications]]",
    'kind = "helix_crowning"',
    "amount_um = 2000",
    "flank = { left = 1 }",
    "[machine]",
    'file = "m.toml"',
  ].join("\n");
  it("is its own, or that of the nearest around it", () => {
    const line = (field: string): number | undefined => lineOfField(text, parsePath(field));
    expect(line("gear.teeth")).toBe(6);
    expect(line("gear.evaluation.start_diameter")).toBe(7);
    expect(line("target.modifications[0].amount_um")).toBe(11);
    expect(line("target.modifications[1].amount_um")).toBe(15);
    expect(line("target.modifications[1].flank.left")).toBe(16);
    expect(line("target.modifications[1]")).toBe(13);
    expect(line("target.modifications[1].absent")).toBe(13);
    expect(line("machine.file")).toBe(18);
    expect(line("worm.threads")).toBeUndefined();
  });
  it("takes the place of one in the text that the page sent", () => {
    const sent = {
      code: "x",
      message: "m",
      field: "target.modifications[1].amount_um",
      line: 1,
      column: 300,
      start: 299,
      end: 303,
    };
    expect(atOwnLines([sent], text)).toEqual([{ code: "x", message: "m", field: sent.field, line: 15 }]);
    expect(atOwnLines([{ code: "x", message: "m", line: 1 }], text)).toEqual([{ code: "x", message: "m" }]);
    expect(atOwnLines([{ code: "x", message: "m", file: "map.csv", line: 4 }], text)[0]!.line).toBe(4);
  });
});
