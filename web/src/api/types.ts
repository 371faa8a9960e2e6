// What the server answers, as docs/web-application.md tells it.

import type { Json, Path, Table } from "../lib/path";

export interface Finding {
  code: string;
  message: string;
  field?: string | null;
  value?: Json;
  allowed?: string | null;
  way_out?: string | null;
  file?: string | null;
  line?: number | null;
  column?: number | null;
  start?: number | null;
  end?: number | null;
}

export interface Remark {
  code: string;
  text: string;
  way_out?: string | null;
}

export interface FailureDocument {
  exit: number;
  errors: Finding[];
  omitted: number;
}

export interface Job {
  text: string;
  files?: Record<string, string>;
}

export interface About {
  version: string;
  processes: { name: string; title: string }[];
  queue: { running: number; waiting: number; most: number };
}

export interface ExampleHead {
  id: string;
  name: string;
  process: string;
  description?: string | null;
}

export interface MachineHead {
  file: string;
  name: string;
  description?: string | null;
}

export interface Quantity {
  key: string;
  label: string;
  value: number | string | null;
  unit: string;
}

export interface CheckAnswer {
  valid: boolean;
  process?: string | null;
  name?: string | null;
  findings: Finding[];
  warnings: Remark[];
  tree?: Table | null;
  derived: { title: string; quantities: Quantity[] }[];
}

export interface Edit {
  path: Path;
  value: Json;
}

export interface EditAnswer {
  text: string;
  tree: Table;
}

export type RunKind = "plan" | "simulate" | "explore" | "inspect";
export type RunState = "queued" | "running" | "done" | "failed" | "cancelled" | "interrupted";
export type Verdict = "met" | "missed" | "not_judged";

export interface Progress {
  stage: string;
  done: number;
  total: number;
}

export interface RunSummary {
  id: string | number;
  kind: RunKind;
  name: string;
  state: RunState;
  created: string;
  ended?: string | null;
  status?: Verdict | null;
  progress?: Progress | null;
}

export interface RunFile {
  name: string;
  bytes: number;
}

/** A chart of a result: the name by which it is asked for, its title, and the section of the report in which it stands. */
export interface ChartHead {
  name: string;
  title: string;
  section: string;
}

export interface Run extends RunSummary {
  job?: Job | null;
  /** Names of the measurements that were handed in. */
  measurements?: string[];
  document?: Table | null;
  failure?: FailureDocument | null;
  files: RunFile[];
  charts: ChartHead[];
  /** Whether its bodies can be seen in space. */
  scene: boolean;
}

export type Characteristics = Record<string, number | null>;

export interface PreviewFlank {
  w_mm: number[];
  z_mm: number[];
  target_um: number[][];
  planned_um: number[][];
  max_deviation_um: number;
  rms_deviation_um: number;
  target_characteristics: Characteristics;
  planned_characteristics: Characteristics;
}

export interface Preview {
  process: string;
  tolerance_um: number;
  settings: Table;
  warnings: Remark[];
  charts: Record<string, string>;
  flanks: { left?: PreviewFlank; right?: PreviewFlank };
  milliseconds: number;
}

export interface SceneBody {
  id: string;
  kind: string;
  positions: number[];
  indices: number[];
  /** Whether the triangles close it; an open body is seen from both sides. */
  closed?: boolean;
}

export interface SceneFrame {
  at: number;
  poses: Record<string, number[]>;
  contact: [number, number, number][];
  /** Lines on the workpiece that are finished here. */
  trace?: [number, number, number][][];
}

export interface SceneStage {
  id: string;
  title: string;
  coordinate: { label: string; unit: string };
  frames: SceneFrame[];
}

export interface Scene {
  bodies: SceneBody[];
  stages: SceneStage[];
}

export interface SeriesSummary {
  series: string;
  parts: number;
  first?: string | null;
  last?: string | null;
}

export interface PartSummary {
  series: string;
  part: string;
  drawing?: string | null;
  date?: string | null;
  machine?: string | null;
  source: string;
  digest: string;
}

export interface ToolSummary {
  tool: string;
  measurements: number;
}

export interface TrendPoint {
  digest: string;
  part: string;
  date: string | null;
  name: string;
  flank: string | null;
  tooth: number | null;
  statistic: string;
  value: number;
  unit: string;
  lower_limit: number | null;
  upper_limit: number | null;
}
