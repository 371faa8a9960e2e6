// Every request of the interface, one function each.

import { failureOf } from "./failure";
import type {
  About,
  CheckAnswer,
  Edit,
  EditAnswer,
  ExampleHead,
  Job,
  MachineHead,
  PartSummary,
  Preview,
  Run,
  RunKind,
  RunState,
  RunSummary,
  Scene,
  SeriesSummary,
  ToolSummary,
  TrendPoint,
} from "./types";
import type { Table } from "../lib/path";
import type { Schema } from "../lib/schema";

type Id = string | number;
const enc = (part: Id): string => encodeURIComponent(String(part));

async function request(path: string, init: RequestInit = {}): Promise<Response> {
  const response = await fetch(`/api/${path}`, init);
  if (!response.ok) throw await failureOf(response);
  return response;
}

async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  const response = await request(path, signal ? { signal } : {});
  return (await response.json()) as T;
}

async function post<T>(path: string, body: unknown, signal?: AbortSignal): Promise<T> {
  const init: RequestInit = {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body ?? {}),
  };
  if (signal) init.signal = signal;
  return (await (await request(path, init)).json()) as T;
}

/** A list by query parameters; those without a value are left out. */
function withQuery(path: string, query: Record<string, string | number | undefined>): string {
  const given = Object.entries(query).filter(([, value]) => value !== undefined && value !== "");
  return given.length === 0 ? path : `${path}?${given.map(([key, value]) => `${key}=${enc(value!)}`).join("&")}`;
}

export const about = (): Promise<About> => get("about");
export const schema = (): Promise<Schema> => get("schema");
export const examples = (): Promise<ExampleHead[]> => get("examples");
export const example = (id: string): Promise<Job> => get(`examples/${id.split("/").map(enc).join("/")}`);
export const template = (process: string): Promise<{ text: string }> => get(`templates/${enc(process)}`);
export const machines = (): Promise<MachineHead[]> => get("machines");

export const check = (job: Job, signal?: AbortSignal): Promise<CheckAnswer> => post("check", job, signal);
export const edit = (text: string, edits: Edit[]): Promise<EditAnswer> => post("edit", { text, edits });
export const preview = (job: Job, charts: string[], signal?: AbortSignal): Promise<Preview> =>
  post("preview", { job, charts }, signal);

export const startRun = (kind: RunKind, job: Job): Promise<{ id: Id }> => post("runs", { kind, job });
export const runs = (most: number): Promise<RunSummary[]> => get(`runs?most=${most}`);
export const run = (id: Id): Promise<Run> => get(`runs/${enc(id)}`);
export const cancelRun = (id: Id): Promise<{ state: RunState }> => post(`runs/${enc(id)}/cancel`, {});
export const repeatRun = (id: Id): Promise<{ id: Id }> => post(`runs/${enc(id)}/again`, {});
export const deleteRun = async (id: Id): Promise<void> => void (await request(`runs/${enc(id)}`, { method: "DELETE" }));
export const eventsAddress = (id: Id): string => `/api/runs/${enc(id)}/events`;
export const archiveAddress = (id: Id): string => `/api/runs/${enc(id)}/archive`;
export const fileAddress = (id: Id, name: string): string => `/api/runs/${enc(id)}/files/${name.split("/").map(enc).join("/")}`;
export const file = async (id: Id, name: string): Promise<string> => (await fetchAddress(fileAddress(id, name))).text();
export const chart = async (id: Id, name: string): Promise<string> =>
  (await request(`runs/${enc(id)}/charts/${enc(name)}`)).text();
export const scene = (id: Id): Promise<Scene> => get(`runs/${enc(id)}/scene`);

async function fetchAddress(address: string): Promise<Response> {
  return request(address.replace(/^\/api\//, ""));
}

export async function sendMeasurements(files: File[], job: Job | undefined, options: Table): Promise<{ id: Id }> {
  const form = new FormData();
  for (const file of files) form.append("file", file, file.name);
  if (job) form.append("job", new Blob([JSON.stringify(job)], { type: "application/json" }));
  if (Object.keys(options).length > 0) {
    form.append("options", new Blob([JSON.stringify(options)], { type: "application/json" }));
  }
  return (await (await request("measurements", { method: "POST", body: form })).json()) as { id: Id };
}

export const checkProgram = (text: string, name: string, machine: string, job?: Job): Promise<Table> =>
  post("programs/check", job ? { text, name, machine, job } : { text, name, machine });

export const series = (): Promise<SeriesSummary[]> => get("series");
export const parts = (series?: string): Promise<PartSummary[]> => get(withQuery("parts", { series }));
export const part = (digest: string): Promise<Table> => get(`parts/${enc(digest)}`);
export const trends = (query: { series?: string; name?: string; flank?: string }): Promise<TrendPoint[]> =>
  get(withQuery("trends", query));
export const catalogue = (): Promise<Table> => get("catalogue");
export const tools = (): Promise<ToolSummary[]> => get("tools");
export const tool = (name: string): Promise<Table[]> => get(`tools/${enc(name)}`);
