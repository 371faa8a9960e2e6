// From the schema of jobs to the model of the form.

import { describe, expect, it } from "vitest";
import { helpOf, isInRange, JobSchema, rangeText, type Schema } from "../src/lib/schema";

const angle: Schema = { type: "number", minimum: 5, maximum: 45 };
const SCHEMA: Schema = {
  allOf: [
    {
      if: { properties: { job: { properties: { process: { const: "grinding" } } } } },
      then: { $ref: "#/$defs/Job" },
    },
  ],
  $defs: {
    Job: {
      type: "object",
      required: ["job", "gear"],
      properties: {
        gear: { $ref: "#/$defs/Gear", description: "The workpiece." },
        job: { type: "object" },
        target: { $ref: "#/$defs/Target" },
      },
    },
    Gear: {
      type: "object",
      description: "Drawing data.",
      required: ["teeth", "angle_deg"],
      properties: {
        angle_deg: { anyOf: [angle, { type: "object", required: ["left", "right"], properties: { left: angle, right: angle } }] },
        hand: { $ref: "#/$defs/Hand" },
        teeth: { type: "integer", minimum: -2000, maximum: 2000, "x-way-out": "give the number of teeth" },
        width: { type: "number", exclusiveMinimum: 0, maximum: 5000, default: 10 },
      },
    },
    Hand: {
      oneOf: [
        { const: "left", type: "string", description: "Sign\n-1." },
        { const: "right", type: "string" },
      ],
    },
    Target: { type: "object", properties: { modifications: { type: "array", items: { $ref: "#/$defs/Modification" } } } },
    Modification: {
      oneOf: [
        {
          type: "object",
          required: ["kind", "amount_um"],
          properties: { kind: { const: "twist", type: "string" }, amount_um: { type: "number" } },
        },
        {
          type: "object",
          required: ["kind", "children"],
          properties: {
            kind: { const: "sum", type: "string" },
            children: { type: "array", items: { $ref: "#/$defs/Modification" } },
          },
        },
      ],
    },
    Ratio: { anyOf: [{ type: "number" }, { oneOf: [{ const: "auto", type: "string" }] }] },
  },
};
const forms = new JobSchema(SCHEMA);
const job = forms.ofProcess("grinding")!;
const gear = forms.resolve(job.properties!["gear"]!);

describe("JobSchema", () => {
  it("finds the tables of a process and follows references, whose neighbours win", () => {
    expect(forms.ofProcess("casting")).toBeUndefined();
    expect(gear.description).toBe("The workpiece.");
    expect(forms.fields(job).map((field) => field.key)).toEqual(["job", "gear", "target"]);
  });
  it("puts required entries first and tells unit, default and way out", () => {
    const fields = forms.fields(gear);
    expect(fields.map((field) => field.key)).toEqual(["teeth", "angle_deg", "hand", "width"]);
    expect(fields[0]).toMatchObject({ required: true, wayOut: "give the number of teeth", unit: "" });
    expect(fields[1]).toMatchObject({ unit: "°" });
    expect(fields[3]).toMatchObject({ standard: 10, unit: "mm", required: false });
  });
  it("knows what control a value takes", () => {
    expect(forms.node(gear.properties!["teeth"]!)).toMatchObject({ type: "number", integer: true });
    expect(forms.node(gear.properties!["hand"]!)).toMatchObject({
      type: "word",
      words: [{ value: "left", help: { key: "Hand=left", english: "Sign -1." } }, { value: "right" }],
    });
    expect(forms.node({ $ref: "#/$defs/Ratio" }).type).toBe("choice");
    expect(forms.node({ type: "boolean" }).type).toBe("switch");
    expect(forms.node({ type: "object", additionalProperties: { type: "number" } }).type).toBe("map");
  });
  it("tells the shape of a value that may have several", () => {
    const node = forms.node(gear.properties!["angle_deg"]!);
    if (node.type !== "choice") throw new Error(node.type);
    expect(forms.variantOf(node.variants, 17.5)).toBe(0);
    expect(forms.variantOf(node.variants, { left: 25, right: 18 })).toBe(1);
  });
  it("starts entries of kinds with what they require, also where kinds hold kinds", () => {
    const node = forms.node({ $ref: "#/$defs/Modification" });
    if (node.type !== "kinds") throw new Error(node.type);
    expect(forms.start({ $ref: "#/$defs/Modification" })).toEqual({ kind: "twist", amount_um: 0 });
    expect(forms.startKind(node, "sum")).toEqual({ kind: "sum", children: [] });
  });
  it("starts numbers inside their range", () => {
    expect(forms.start({ type: "number", exclusiveMinimum: 0 })).toBe(1);
    expect(forms.start({ type: "number", minimum: 2, maximum: 9 })).toBe(2);
    expect(forms.start({ type: "number", minimum: -9, maximum: 9 })).toBe(0);
  });
});

describe("keys of help", () => {
  it("say where a description stands, whatever its words", () => {
    expect(forms.fields(job).find((field) => field.key === "gear")?.help).toEqual({ key: "Job.gear", english: "The workpiece." });
    expect(helpOf(forms.resolve({ $ref: "#/$defs/Gear" }))).toEqual({ key: "Gear", english: "Drawing data." });
  });
});

describe("ranges", () => {
  it("are told and kept", () => {
    const range = { exclusiveMinimum: 0, maximum: 5000 };
    expect(rangeText(range)).toBe("> 0, ≤ 5000");
    expect(isInRange(0, range)).toBe(false);
    expect(isInRange(5000, range)).toBe(true);
    expect(rangeText({})).toBe("");
  });
});
