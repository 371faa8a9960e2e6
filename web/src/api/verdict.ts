// The verdict of a run as its document states it: status, whether it is accepted, why not, and what was judged. No page computes a
// status of its own.

import type { JudgedItem, Remark, ResultDocument, RunSummary, UnjudgedItem, Verdict } from "./types";

/** The keys in which a document states it. */
export type Judged = Pick<ResultDocument, "status" | "accepted" | "reason" | "scope">;

export interface StatedVerdict {
  status: Verdict;
  accepted: boolean;
  reason: Remark | undefined;
  judged: JudgedItem[];
  notJudged: UnjudgedItem[];
}

const STATUSES: readonly string[] = ["met", "missed", "not_judged"] satisfies Verdict[];
const isStatus = (value: unknown): value is Verdict => typeof value === "string" && STATUSES.includes(value);

/** What a document says of itself; undefined where it states no status. */
export function verdictOf(document: Judged | null | undefined): StatedVerdict | undefined {
  if (!document || !isStatus(document.status)) return undefined;
  return {
    status: document.status,
    accepted: document.accepted === true,
    reason: document.reason ?? undefined,
    judged: (document.scope?.judged ?? []).map(({ item, status, detail }) => ({
      item: item ?? "",
      status: isStatus(status) ? status : "not_judged",
      detail: detail ?? "",
    })),
    notJudged: (document.scope?.not_judged ?? []).map(({ item, asked, why }) => ({
      item: item ?? "",
      asked: asked === true,
      why: why ?? "",
    })),
  };
}

/** The status of a run: that of its document where it is at hand, else that of the list. */
export function statusOfRun(run: RunSummary & { document?: Judged | null }): Verdict | undefined {
  return verdictOf(run.document)?.status ?? run.status ?? undefined;
}

/** The status of one item of the scope, such as "left flank"; undefined where it was not judged or is not named. */
export function statusOfItem(verdict: StatedVerdict | undefined, item: string): Verdict | undefined {
  return verdict?.judged.find((some) => some.item === item)?.status;
}
