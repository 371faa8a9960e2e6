// What the server answers, by the names of the pages. The types themselves are made from its description.

import type { components } from "./generated";
import type { Json } from "../lib/path";

type Schemas = components["schemas"];

export type Finding = Schemas["Finding"];
export type Remark = Found<Schemas["Remark"]>;
export type FailureDocument = Schemas["Failure"];

export type Job = Schemas["Job"];
export type About = Schemas["About"];
export type ExampleHead = Schemas["ExampleSummary"];
export type MachineHead = Schemas["MachineSummary"];
export type CheckAnswer = Schemas["CheckAnswer"];
export type Edit = Schemas["Edit"];

export type RunKind = Schemas["Task"];
export type RunState = Schemas["RunState"];
export type Verdict = Schemas["Status"];
export type RunStateAnswer = Schemas["RunStateAnswer"];
export type RunBegun = Schemas["RunBegun"];
export type Progress = Schemas["Advance"];
export type RunSummary = Schemas["ListedRun"];
export type Run = Omit<Schemas["Run"], "document"> & { document?: ResultDocument | null };

export type Preview = Schemas["PreviewAnswer"];

export type Scene = Schemas["Scene"];
export type SceneBody = Schemas["Body"];
export type SceneFrame = Schemas["Frame"];
export type SceneStage = Schemas["Stage"];

export type InspectOptions = Schemas["InspectOptions"];
export type SeriesSummary = Schemas["SeriesSummary"];
export type PartRecord = Schemas["PartRecord"];
export type PartSummary = Schemas["PartSummary"];
export type ToolSummary = Schemas["ToolSummary"];
export type TrendPoint = Schemas["MeasuredCharacteristic"];

/** A document of any kind that a run writes. */
export type ResultDocument = Found<Schemas["ResultDocument"]>;
export type ResultFlank = NonNullable<NonNullable<ResultDocument["flanks"]>[string]>;
export type InspectionRound = NonNullable<ResultDocument["rounds"]>[number];
export type Settings = NonNullable<ResultDocument["settings"]>;
export type ProgramAxis = Found<Schemas["AxisResult"] | Schemas["CheckedAxis"]>;
export type JudgedItem = Schemas["JudgedItem"];
export type UnjudgedItem = Schemas["UnjudgedItem"];
export type CheckedProgram = Found<Schemas["CheckedProgram"]>;
export type HistoryRecord = Found<Schemas["HistoryRecord"]>;
export type Catalogue = Schemas["CatalogueAnswer"];

type KeyOf<T> = T extends unknown ? keyof T : never;
type At<T, Key> = T extends unknown ? (Key extends keyof T ? T[Key] : never) : never;
type List<T> = Extract<T, readonly unknown[]>;
type Keyed<T> = Exclude<Extract<T, object>, readonly unknown[]>;
type ValueOf<T> = T extends unknown ? T[keyof T] : never;

/**
 * A document as a page finds it: the keys of all its kinds, none of which has to be there. Stored documents may come from another version,
 * and a number that is none is null.
 */
export type Found<T> = Json extends T
  ? T
  : | Exclude<T, object>
    | ([List<T>] extends [never] ? never : Found<List<T>[number]>[])
    | ([Keyed<T>] extends [never]
        ? never
        : string extends KeyOf<Keyed<T>>
          ? { [key: string]: Found<ValueOf<Keyed<T>>> | null }
          : { [Key in KeyOf<Keyed<T>>]?: Found<At<Keyed<T>, Key>> | null });
