// Every request of the interface, one function each.

import { addressOf, get, post, request } from "./request";
import type {
  CheckAnswer,
  CheckedProgram,
  Edit,
  HistoryRecord,
  InspectOptions,
  Job,
  Preview,
  Run,
  RunBegun,
  RunKind,
} from "./types";
import type { Schema } from "../lib/schema";

type Id = string | number;

export const about = () => get("/api/about", {});
export const schema = async (): Promise<Schema> => (await get("/api/schema", {})) as Schema;
export const examples = () => get("/api/examples", {});
export const example = (id: string) => get("/api/examples/{id}", { id: id.split("/") });
export const template = (process: string) => get("/api/templates/{process}", { process });
export const machines = () => get("/api/machines", {});

export const check = (job: Job, signal?: AbortSignal): Promise<CheckAnswer> => post("/api/check", {}, job, signal);
export const edit = (text: string, edits: Edit[]) => post("/api/edit", {}, { text, edits });
export const preview = (job: Job, charts: string[], signal?: AbortSignal): Promise<Preview> =>
  post("/api/preview", {}, { job, charts }, signal);

export const startRun = (kind: RunKind, job: Job) => post("/api/runs", {}, { kind, job });
export const runs = (most: number) => get("/api/runs", {}, { most });
export const run = (id: Id): Promise<Run> => get("/api/runs/{id}", { id });
export const cancelRun = (id: Id) => post("/api/runs/{id}/cancel", { id }, undefined);
export const repeatRun = (id: Id) => post("/api/runs/{id}/again", { id }, undefined);
export const deleteRun = async (id: Id): Promise<void> =>
  void (await request(addressOf("/api/runs/{id}", { id }), { method: "DELETE" }));
export const eventsAddress = (id: Id): string => addressOf("/api/runs/{id}/events", { id });
export const archiveAddress = (id: Id): string => addressOf("/api/runs/{id}/archive", { id });
export const fileAddress = (id: Id, name: string): string =>
  addressOf("/api/runs/{id}/files/{name}", { id, name: name.split("/") });
export const file = async (id: Id, name: string): Promise<string> => (await request(fileAddress(id, name))).text();
export const chart = async (id: Id, name: string): Promise<string> =>
  (await request(addressOf("/api/runs/{id}/charts/{name}", { id, name }))).text();
export const scene = (id: Id) => get("/api/runs/{id}/scene", { id });

/** Files, or a part of the store in their place by its digest. */
export async function sendMeasurements(
  measured: File[] | string,
  job: Job | undefined,
  options: InspectOptions,
): Promise<RunBegun> {
  const form = new FormData();
  if (typeof measured === "string") form.append("part", measured);
  else for (const file of measured) form.append("file", file, file.name);
  if (job) form.append("job", new Blob([JSON.stringify(job)], { type: "application/json" }));
  if (Object.keys(options).length > 0) {
    form.append("options", new Blob([JSON.stringify(options)], { type: "application/json" }));
  }
  return (await (await request(addressOf("/api/measurements", {}), { method: "POST", body: form })).json()) as RunBegun;
}

export const checkProgram = (text: string, name: string, machine: string, job?: Job): Promise<CheckedProgram> =>
  post("/api/programs/check", {}, job ? { text, name, machine, job } : { text, name, machine });

export const series = () => get("/api/series", {});
export const parts = (series?: string) => get("/api/parts", {}, { series });
export const part = (digest: string) => get("/api/parts/{digest}", { digest });
export const trends = (query: { series?: string; name?: string; flank?: string }) => get("/api/trends", {}, query);
export const catalogue = () => get("/api/catalogue", {});
export const tools = () => get("/api/tools", {});
export const tool = (name: string): Promise<HistoryRecord[]> => get("/api/tools/{tool}", { tool: name });
