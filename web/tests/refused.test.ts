// A run that was refused offers what it wrote all the same: its reason, its report with its pictures, its files.

import { render } from "svelte/server";
import { describe, expect, it, vi } from "vitest";
import type { Run } from "../src/api/types";
import { hasTabs, tabsOf } from "../src/runs/tabs";

vi.mock("../src/lib/router.svelte", () => ({ router: { go: vi.fn(), parts: [] } }));

const refused = (files: string[], charts: Run["charts"] = []): Run => ({
  id: 7,
  kind: "plan",
  name: "housing",
  state: "failed",
  created: "2026-01-01T00:00:00Z",
  status: null,
  measurements: [],
  files: files.map((name) => ({ name, bytes: 1 })),
  charts,
  scene: false,
  document: null,
  failure: {
    exit: 4,
    errors: [{ code: "worm-too-short", message: "the worm is too short", way_out: "take a worm of 250 mm" }],
    omitted: 0,
  },
});
const WRITTEN = ["result.json", "report.html"];

describe("a refused run", () => {
  it("has the tabs of what it wrote", () => {
    const charts = [{ name: "reach-of-the-worm", title: "Reach of the worm", section: "What limits" }];
    expect(hasTabs(refused(WRITTEN))).toBe(true);
    expect(tabsOf(refused(WRITTEN, charts))).toEqual(["reason", "motions", "report", "files"]);
    expect(tabsOf(refused(WRITTEN))).toEqual(["reason", "report", "files"]);
    expect(tabsOf({ ...refused(WRITTEN), kind: "explore" })).toEqual(["reason", "report", "files"]);
  });
  it("without a report has none, nor one that is under way", () => {
    expect(hasTabs(refused([]))).toBe(false);
    expect(hasTabs({ ...refused(WRITTEN), state: "running" })).toBe(false);
  });
  it("leads from its reason to its report", async () => {
    const { default: FailedTab } = await import("../src/runs/FailedTab.svelte");
    const { body } = render(FailedTab, { props: { run: refused(WRITTEN) } });
    for (const said of ["the worm is too short", "take a worm of 250 mm", 'href="#/runs/7/report"']) {
      expect(body, said).toContain(said);
    }
  });
  it("without a report has no link to one", async () => {
    const { default: FailedTab } = await import("../src/runs/FailedTab.svelte");
    const { body } = render(FailedTab, { props: { run: refused([]) } });
    expect(body).toContain("the worm is too short");
    expect(body).not.toContain("#/runs/7/report");
  });
});
