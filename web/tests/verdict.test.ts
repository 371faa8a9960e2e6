// One verdict everywhere: pages take it from the document and compute none.

import { describe, expect, it } from "vitest";
import { statusOfItem, statusOfRun, verdictOf } from "../src/api/verdict";
import type { ResultDocument, RunSummary } from "../src/api/types";
import { de } from "../src/texts/de";
import { en } from "../src/texts/en";

const document: ResultDocument = {
  status: "not_judged",
  accepted: false,
  reason: { code: "root-not-judged", text: "the root was not simulated", way_out: "give simulation.rays_length" },
  scope: {
    judged: [{ item: "left flank", status: "met", detail: "0.2 of 1 um" }],
    not_judged: [
      { item: "root", asked: true, why: "the root was not simulated" },
      { item: "hub", asked: false, why: "the job names none" },
    ],
  },
};

describe("the verdict of a document", () => {
  it("has status, acceptance, reason and scope", () => {
    const verdict = verdictOf(document)!;
    expect(verdict.status).toBe("not_judged");
    expect(verdict.accepted).toBe(false);
    expect(verdict.reason?.code).toBe("root-not-judged");
    expect(verdict.judged).toEqual([{ item: "left flank", status: "met", detail: "0.2 of 1 um" }]);
    expect(verdict.notJudged.map((some) => [some.item, some.asked])).toEqual([
      ["root", true],
      ["hub", false],
    ]);
    expect(statusOfItem(verdict, "left flank")).toBe("met");
    expect(statusOfItem(verdict, "root")).toBeUndefined();
  });
  it("is absent where a document states none, whatever its numbers are", () => {
    expect(verdictOf({ tolerance_um: 1 } as ResultDocument)).toBeUndefined();
    expect(verdictOf({ status: "fine" } as object)).toBeUndefined();
    expect(verdictOf(undefined)).toBeUndefined();
  });
  it("comes before what a list says", () => {
    const run: RunSummary = { id: 1, kind: "inspect", name: "part", state: "done", created: "", status: "met" };
    expect(statusOfRun(run)).toBe("met");
    expect(statusOfRun({ ...run, document })).toBe("not_judged");
  });
  it("has the same three words as the command", () => {
    expect(en.run.verdicts).toEqual({ met: "met", missed: "missed", not_judged: "not judged" });
    expect(de.run.verdicts).toEqual({ met: "erreicht", missed: "verfehlt", not_judged: "nicht beurteilt" });
  });
});

describe("check marks", () => {
  it("stand for no verdict: they belong to the check of a job and to what was copied", () => {
    const files = import.meta.glob<string>("../src/**/*.svelte", { query: "?raw", import: "default", eager: true });
    const marked = Object.keys(files).filter((name) => /(?<!=== )"check"/.test(files[name]!));
    expect(marked.map((name) => name.split("/").at(-1)).sort()).toEqual(["JobBar.svelte", "ProgramText.svelte"]);
  });
});
