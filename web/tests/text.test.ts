// Places in the text of a job.

import { describe, expect, it } from "vitest";
import { changeBetween, looksLikeJob, namedFiles, rangeOfFinding } from "../src/job/text";

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
