// What went wrong with a request: the findings of the server, or why there is no answer at all.

import type { FailureDocument, Finding } from "./types";

export type FailureKind = "refused" | "unreachable" | "unauthorised" | "missing" | "busy" | "broken" | "outdated";

export class RequestFailure extends Error {
  constructor(
    readonly kind: FailureKind,
    readonly status: number,
    readonly findings: Finding[],
    readonly omitted = 0,
  ) {
    super(findings[0]?.message ?? `status ${status}`);
  }
}

function kindOf(status: number): FailureKind {
  if (status === 401) return "unauthorised";
  if (status === 404) return "missing";
  if (status === 429 || status === 503) return "busy";
  return status >= 500 ? "broken" : "refused";
}

/** The failure that a response tells; a body that is none is told by its status alone. */
export async function failureOf(response: Response): Promise<RequestFailure> {
  let findings: Finding[] = [];
  let omitted = 0;
  const text = await response.text().catch(() => "");
  try {
    const document = JSON.parse(text) as Partial<FailureDocument>;
    findings = document.errors ?? [];
    omitted = document.omitted ?? 0;
  } catch {
    if (text !== "") findings = [{ code: `http-${response.status}`, message: text.slice(0, 300) }];
  }
  return new RequestFailure(kindOf(response.status), response.status, findings, omitted);
}

/** Any thrown thing as a failure of a request. */
export function asFailure(error: unknown): RequestFailure {
  if (error instanceof RequestFailure) return error;
  if (error instanceof TypeError) return new RequestFailure("unreachable", 0, []);
  const message = error instanceof Error ? error.message : String(error);
  return new RequestFailure("broken", 0, [{ code: "page", message }]);
}

export function isAborted(error: unknown): boolean {
  return error instanceof DOMException && error.name === "AbortError";
}
