// Programs of a result: what each does, its axes and how it is proven.

import { isTable, type Json, type Table } from "../lib/path";
import type { Run, Verdict } from "../api/types";
import type { StatedVerdict } from "../api/verdict";

export interface ProgramAxis {
  axis: string;
  word?: string;
  unit: string;
  from: number;
  to: number;
  way: number;
  velocity?: number;
  acceleration?: number;
  min?: number;
  max?: number;
  max_velocity?: number;
  max_acceleration?: number;
}

export interface Program {
  file: string;
  control: string;
  does: string;
  blocks: number | undefined;
  duration: number | undefined;
  axes: ProgramAxis[];
  /** What it does one after another: passes of grinding, operations of milling. */
  passes: Table[];
  remarks: string[];
  proof: string | undefined;
  /** The largest deviation from the target that the proof found on a flank, in µm. */
  deviation: number | undefined;
  /** What the program and the plan differ by, and may, in µm. */
  difference: number | undefined;
  allowed: number | undefined;
}

const number = (value: Json | undefined): number | undefined => (typeof value === "number" ? value : undefined);
const words = (value: Json | undefined): string[] =>
  Array.isArray(value) ? value.filter((some): some is string => typeof some === "string") : [];
const tables = (value: Json | undefined): Table[] => (Array.isArray(value) ? value.filter(isTable) : []);

/** The programs among the files of a run, with what the result says of them. */
export function programsOf(run: Run): Program[] {
  const told = run.document?.["programs"];
  const list = tables(isTable(told) ? told["programs"] : told);
  const proofs = tables(isTable(told) ? told["proofs"] : undefined);
  const files = run.files.map((file) => file.name).filter((name) => name.startsWith("programs/"));
  return files.map((file) => {
    const entry = list.find((some) => some["file"] === file) ?? {};
    const control = typeof entry["control"] === "string" ? entry["control"] : "";
    const proof = proofs.find((some) => Array.isArray(some["controls"]) && some["controls"].includes(control));
    return {
      file,
      control,
      does: typeof entry["job"] === "string" ? entry["job"] : (/([a-z]+)-[a-z]+\.[a-z]+$/.exec(file)?.[1] ?? ""),
      blocks: number(entry["blocks"]),
      duration: number(entry["duration_s"]),
      axes: tables(entry["axes"]) as unknown as ProgramAxis[],
      passes: [...tables(entry["passes"]), ...tables(entry["operations"])],
      remarks: words(entry["remarks"]),
      proof: typeof proof?.["statement"] === "string" ? proof["statement"] : undefined,
      deviation: deviationOf(proof),
      difference: number(entry["proof_difference_um"]),
      allowed: number(entry["proof_allowed_um"]),
    };
  });
}

function deviationOf(proof: Table | undefined): number | undefined {
  const flanks = isTable(proof?.["flanks"]) ? Object.values(proof["flanks"]).filter(isTable) : [];
  const found = flanks.map((flank) => number(flank["max_deviation_um"])).filter((some) => some !== undefined);
  return found.length === 0 ? undefined : Math.max(...found);
}

/**
 * The mark of a program: the verdict of its run, for a program is no better than what it makes. A text that differs from the plan by
 * more than blocks and digits explain is missed; one without a proof is not judged.
 */
export function markOf(program: Program, verdict: StatedVerdict | undefined): Verdict {
  const { proof, difference, allowed } = program;
  if (difference !== undefined && allowed !== undefined && difference > allowed) return "missed";
  if (!verdict) return "not_judged";
  if (verdict.status === "met" && proof === undefined && difference === undefined) return "not_judged";
  return verdict.status;
}

export type Nearness = "near" | "at" | "over";
/** Shares of a limit from which a bar is marked: little is left, nothing is left, beyond by more than rounding. */
const NEAR = 0.95;
const AT = 0.9995;
const OVER = 1.0005;

/** How near a share comes to its limit; undefined where there is room. */
export function nearnessOf(share: number | undefined): Nearness | undefined {
  if (share === undefined || !(share >= NEAR)) return undefined;
  return share > OVER ? "over" : share >= AT ? "at" : "near";
}

/** How near an axis comes to the ends of its travel, by the nearer end. */
export function travelNearness(axis: ProgramAxis): Nearness | undefined {
  if (axis.min === undefined || axis.max === undefined || !(axis.max > axis.min)) return undefined;
  const room = axis.max - axis.min;
  const [low, high] = [Math.min(axis.from, axis.to), Math.max(axis.from, axis.to)];
  const middle = (axis.min + axis.max) / 2;
  return nearnessOf(Math.max(middle - low, high - middle) / (room / 2));
}

/** The axis of which a chart tells, of its own program or of the first that does the same: "Dressing: Axis X1, word X". */
export function axisOfChart(title: string, programs: Program[]): ProgramAxis | undefined {
  const [, does, name] = /^(?:(.+): )?Axis (\w+)/.exec(title) ?? [];
  if (name === undefined) return undefined;
  const same = programs.filter((program) => does === undefined || program.does === does.toLowerCase());
  return same.flatMap((program) => program.axes).find((axis) => axis.axis === name);
}

/** The first lines of a text. */
export function firstLines(text: string, count: number): { lines: string; isWhole: boolean } {
  const lines = text.split("\n");
  return lines.length <= count ? { lines: text, isWhole: true } : { lines: lines.slice(0, count).join("\n"), isWhole: false };
}
