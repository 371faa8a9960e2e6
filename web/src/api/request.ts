// One request of the interface. Its path, what stands in its path and query, its body and its answer have the types of the description.

import { failureOf } from "./failure";
import type { paths } from "./generated";

type Path = keyof paths;
type Content<T> = T extends { content: { "application/json": infer Body } } ? Body : never;
type Operation<P extends Path, Method extends "get" | "post"> = Exclude<paths[P][Method], undefined>;
type Answer<T> = T extends { responses: infer Answers } ? Content<Answers[keyof Answers & (200 | 202)]> : never;
type Parameters<T, In extends string> = T extends { parameters: { [Key in In]?: infer Given } }
  ? Exclude<Given, undefined>
  : never;

/** The paths that take a method and answer JSON. */
type PathOf<Method extends "get" | "post"> = { [P in Path]: [Answer<Operation<P, Method>>] extends [never] ? never : P }[Path];
type Place = string | number | readonly string[];
/** What stands in a path; a list keeps its slashes. */
export type Places<P extends Path> = { [Key in keyof Parameters<paths[P]["get" | "post"], "path">]: Place };
type Query<P extends Path> = Parameters<Operation<P, "get">, "query">;

const enc = (part: string | number): string => encodeURIComponent(String(part));

/** The address of a path. */
export function addressOf<P extends Path>(path: P, places: Places<P>, query: object = {}): string {
  const given = places as Record<string, Place>;
  const filled = path.replace(/\{(\w+)\}/g, (_, name: string) => [given[name] ?? ""].flat().map(enc).join("/"));
  // Parameters without a value are left out.
  const asked = Object.entries(query).filter(([, value]) => value !== undefined && value !== "");
  return asked.length === 0 ? filled : `${filled}?${asked.map(([key, value]) => `${key}=${enc(value as string)}`).join("&")}`;
}

export async function request(address: string, init: RequestInit = {}): Promise<Response> {
  const response = await fetch(address, init);
  if (!response.ok) throw await failureOf(response);
  return response;
}

type Got<P extends PathOf<"get">> = Answer<Operation<P, "get">>;
type Posted<P extends PathOf<"post">> = Answer<Operation<P, "post">>;
type Body<P extends PathOf<"post">> = Operation<P, "post"> extends { requestBody: infer Asked } ? Content<Asked> : undefined;

export async function get<P extends PathOf<"get">>(path: P, places: Places<P>, query?: Query<P>): Promise<Got<P>> {
  return (await (await request(addressOf(path, places, query))).json()) as Got<P>;
}

export async function post<P extends PathOf<"post">>(
  path: P,
  places: Places<P>,
  body: Body<P>,
  signal?: AbortSignal,
): Promise<Posted<P>> {
  const init: RequestInit = {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body ?? {}),
  };
  if (signal) init.signal = signal;
  return (await (await request(addressOf(path, places), init)).json()) as Posted<P>;
}
