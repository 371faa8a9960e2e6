// Programs of a result: what each does, its axes and how it is proven.

import type { ProgramAxis, ResultDocument, Run, Verdict } from "../api/types";
import type { StatedVerdict } from "../api/verdict";
import type { Table } from "../lib/path";

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

type Told = NonNullable<ResultDocument["programs"]>;
type Entry = Extract<Told, unknown[]>[number] & Partial<NonNullable<Exclude<Told, unknown[]>["programs"]>[number]>;
type Proof = NonNullable<Exclude<Told, unknown[]>["proofs"]>[number];

/** The programs among the files of a run, with what the result says of them. */
export function programsOf(run: Run): Program[] {
  const told = run.document?.programs;
  const list: Entry[] = (Array.isArray(told) ? told : told?.programs) ?? [];
  const proofs = (Array.isArray(told) ? undefined : told?.proofs) ?? [];
  const files = run.files.map((file) => file.name).filter((name) => name.startsWith("programs/"));
  return files.map((file) => {
    const entry: Entry = list.find((some) => some.file === file) ?? {};
    const control = entry.control ?? "";
    const proof = proofs.find((some) => some.controls?.includes(control));
    return {
      file,
      control,
      does: entry.job ?? /([a-z]+)-[a-z]+\.[a-z]+$/.exec(file)?.[1] ?? "",
      blocks: entry.blocks ?? undefined,
      duration: entry.duration_s ?? undefined,
      axes: entry.axes ?? [],
      passes: [...(entry.passes ?? []), ...(entry.operations ?? [])],
      remarks: entry.remarks ?? [],
      proof: proof?.statement ?? undefined,
      deviation: deviationOf(proof),
      difference: entry.proof_difference_um ?? undefined,
      allowed: entry.proof_allowed_um ?? undefined,
    };
  });
}

function deviationOf(proof: Proof | undefined): number | undefined {
  const found = Object.values(proof?.flanks ?? {}).flatMap((flank) => flank?.max_deviation_um ?? []);
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

/** The travel of an axis and what it uses of it; undefined where the machine states none. */
export function travelOf(axis: ProgramAxis): { min: number; room: number; low: number; high: number } | undefined {
  const { min, max, from, to } = axis;
  if (min == null || max == null || from == null || to == null || !(max > min)) return undefined;
  return { min, room: max - min, low: Math.min(from, to), high: Math.max(from, to) };
}

/** How near an axis comes to the ends of its travel, by the nearer end. */
export function travelNearness(axis: ProgramAxis): Nearness | undefined {
  const travel = travelOf(axis);
  if (!travel) return undefined;
  const middle = travel.min + travel.room / 2;
  return nearnessOf(Math.max(middle - travel.low, travel.high - middle) / (travel.room / 2));
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
