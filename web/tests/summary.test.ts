// What a run's pages say of its verdict, as they are drawn.

import { render } from "svelte/server";
import { describe, expect, it, vi } from "vitest";
import type { ResultDocument, Run } from "../src/api/types";

vi.mock("../src/lib/router.svelte", () => ({ router: { go: vi.fn(), parts: [] } }));
vi.mock("../src/state/theme.svelte", () => ({ theme: { isDark: false } }));

const run = (document: ResultDocument, status: Run["status"] = null): Run => ({
  id: 1,
  kind: "inspect",
  name: "pinion",
  state: "done",
  created: "2026-01-01T00:00:00Z",
  status,
  measurements: [],
  files: [{ name: "programs/job-grinding-siemens.mpf", bytes: 1 }],
  charts: [],
  scene: false,
  document,
});
const flank = { max_deviation_um: 0.2, tolerance_share: 0.2 };

describe("the summary of a run", () => {
  it("shows what was judged and what was not", async () => {
    const { default: SummaryTab } = await import("../src/runs/SummaryTab.svelte");
    const document: ResultDocument = {
      status: "not_judged",
      accepted: false,
      reason: { code: "root-not-judged", text: "the root was not simulated", way_out: "give simulation.rays_length" },
      scope: {
        judged: [{ item: "left flank", status: "met", detail: "0.2 of 1 um" }],
        not_judged: [{ item: "root", asked: true, why: "the root was not simulated" }],
      },
      tolerance_um: 1,
      flanks: { left: flank, right: flank },
    };
    const { body } = render(SummaryTab, { props: { run: run(document) } });
    for (const said of ["What the verdict covers", "0.2 of 1 um", "asked for", "give simulation.rays_length", "exit status 3"]) {
      expect(body, said).toContain(said);
    }
    // The right flank is not in the scope: its small deviation makes no mark.
    expect(body.match(/>met</g)).toHaveLength(2);
    expect(body.match(/>not judged</g)).toHaveLength(2);
  });
  it("of a measurement without a demand is grey, however good its class is", async () => {
    const { default: SummaryTab } = await import("../src/runs/SummaryTab.svelte");
    const document: ResultDocument = {
      status: "not_judged",
      accepted: true,
      scope: { judged: [], not_judged: [] },
      class: 3,
      summary: [],
    };
    const { body } = render(SummaryTab, { props: { run: run(document) } });
    expect(body).toContain("Nothing was asked for, so nothing was judged.");
    expect(body).not.toContain(">met<");
  });
});

describe("the summary of a blank", () => {
  it("has its stock and the table for the job", async () => {
    const { default: SummaryTab } = await import("../src/runs/SummaryTab.svelte");
    const document: ResultDocument = {
      job: "ground",
      files: ["blank.mka"],
      stock_um: { left: [90.04, 101.26, 112.5], right: null },
      teeth_with_traces: { left: 3, right: 0 },
      level_from: "span",
      with_pitch: true,
      remarks: [{ code: "blank-without-pitch", text: "pitches are not known", way_out: "measure them" }],
    };
    const files = [{ name: "stock.csv", bytes: 9 }];
    const { body } = render(SummaryTab, { props: { run: { ...run(document), files } } });
    for (const said of ["101.3", "Level from the measured span", "every tooth", "/api/runs/1/files/stock.csv", "measure them"]) {
      expect(body, said).toContain(said);
    }
    // The figures are shown once.
    expect(body).not.toContain("level_from");
    const { body: bare } = render(SummaryTab, { props: { run: { ...run(document), files: [] } } });
    expect(bare).not.toContain("stock.csv)");
  });
});

describe("the programs of a run", () => {
  it("of a missed target carry no green mark", async () => {
    const { default: ProgramView } = await import("../src/programs/ProgramView.svelte");
    const { programsOf } = await import("../src/programs/model");
    const document: ResultDocument = {
      status: "missed",
      accepted: false,
      tolerance_um: 1,
      reason: { code: "target-missed", text: "the flanks miss the tolerance", way_out: "take other bodies" },
      programs: {
        programs: [
          {
            file: "programs/job-grinding-siemens.mpf",
            control: "siemens",
            job: "grinding",
            axes: [{ axis: "X1", unit: "mm", from: 0, to: 99.9, way: 99.9, velocity: 10, max_velocity: 10 }],
          },
        ],
        proofs: [
          {
            controls: ["siemens"],
            statement: "proven from the program text: max deviation 13.4609 um",
            flanks: { left: { max_deviation_um: 13.4609 } },
          },
        ],
      },
    };
    const some = run(document);
    const { body } = render(ProgramView, { props: { run: some, program: programsOf(some)[0]! } });
    expect(body).toContain(">missed<");
    expect(body).not.toContain(">met<");
    expect(body).toMatch(/deviate by 13\.5\sµm; tolerance 1\sµm/);
    // The speed of the axis is at its limit, in words.
    expect(body.match(/at its limit/g)).toHaveLength(1);
  });
  it("that is checked on a machine tells how near an axis comes to the end of its travel", async () => {
    const { default: AxisTable } = await import("../src/programs/AxisTable.svelte");
    const axes = [{ axis: "X1", unit: "mm", from: 0, to: 99.9, way: 99.9, min: -100, max: 100 }];
    expect(render(AxisTable, { props: { axes } }).body.match(/near its limit/g)).toHaveLength(1);
  });
});

describe("the map of a flank", () => {
  it("has the names and units of its document", async () => {
    const { default: FlankView } = await import("../src/plan/FlankView.svelte");
    const { flanksOfDocument } = await import("../src/plan/surfaces");
    const left = { height_unit: "rad", length_unit: "mm", height: [0.1, 0.2], length: [1, 2], planned_um: [1, 2, 3, 4] };
    const props = {
      flanks: flanksOfDocument({ flanks: { left } }),
      view: "map" as const,
      shown: "planned",
      onshow: () => undefined,
    };
    const { body } = render(FlankView, { props });
    expect(body).toContain("Roll angle [rad]");
    expect(body).toContain("Distance from the apex [mm]");
    expect(body).not.toContain("z [mm]");
  });
});

describe("a job without a plan", () => {
  it("shows an automatic ratio as automatic", async () => {
    const { default: AmountSlider } = await import("../src/plan/AmountSlider.svelte");
    const props = {
      title: "Diagonal ratio",
      note: "",
      value: undefined,
      placeholder: "automatic",
      most: 4,
      step: 0.01,
      unit: "",
      onmove: () => undefined,
      oncommit: () => undefined,
    };
    const { body } = render(AmountSlider, { props });
    expect(body).toMatch(/<input[^>]*value=""[^>]*placeholder="automatic"/);
  });
});

describe("a field of the form", () => {
  it("that the server found something about says so to those who do not see it", async () => {
    const { default: NumberControl } = await import("../src/job/form/NumberControl.svelte");
    const { jobStore } = await import("../src/state/job.svelte");
    const props = {
      node: { type: "number", integer: false, range: {} } as never,
      path: ["gear", "tip_diameter"],
      value: 70,
      unit: "mm",
      standard: undefined,
      required: true,
      label: "Tip diameter",
    };
    const before = render(NumberControl, { props }).body;
    expect(before).toContain('aria-invalid="false"');
    const finding = { code: "invalid-geometry", message: "the tip lies below the root", field: "gear.tip_diameter" };
    jobStore.answer = { valid: false, findings: [finding], omitted: 0, warnings: [], derived: [] };
    const after = render(NumberControl, { props }).body;
    expect(after).toContain('aria-invalid="true"');
    expect(after).toMatch(/aria-describedby="[^"]*field-gear-tip_diameter-findings[^"]*"/);
    jobStore.answer = undefined;
  });
});
