// The verdict of a run as its document states it: status, whether it is accepted, why not, and what was judged. No page computes a
// status of its own.

import { isTable, type Json, type Table } from "../lib/path";
import type { Remark, RunSummary, Verdict } from "./types";

export interface JudgedItem {
  item: string;
  status: Verdict;
  detail: string;
}

export interface UnjudgedItem {
  item: string;
  /** Whether the job asks for it. */
  asked: boolean;
  why: string;
}

export interface StatedVerdict {
  status: Verdict;
  accepted: boolean;
  reason: Remark | undefined;
  judged: JudgedItem[];
  notJudged: UnjudgedItem[];
}

const STATUSES: readonly string[] = ["met", "missed", "not_judged"];
const statusOf = (value: Json | undefined): Verdict | undefined =>
  typeof value === "string" && STATUSES.includes(value) ? (value as Verdict) : undefined;
const tables = (value: Json | undefined): Table[] => (Array.isArray(value) ? value.filter(isTable) : []);
const text = (value: Json | undefined): string => (typeof value === "string" ? value : "");

/** What a document says of itself; undefined where it states no status. */
export function verdictOf(document: Table | null | undefined): StatedVerdict | undefined {
  const status = statusOf(document?.["status"]);
  if (!document || !status) return undefined;
  const scope = isTable(document["scope"]) ? document["scope"] : {};
  return {
    status,
    accepted: document["accepted"] === true,
    reason: isTable(document["reason"]) ? (document["reason"] as unknown as Remark) : undefined,
    judged: tables(scope["judged"]).map((some) => ({
      item: text(some["item"]),
      status: statusOf(some["status"]) ?? "not_judged",
      detail: text(some["detail"]),
    })),
    notJudged: tables(scope["not_judged"]).map((some) => ({
      item: text(some["item"]),
      asked: some["asked"] === true,
      why: text(some["why"]),
    })),
  };
}

/** The status of a run: that of its document where it is at hand, else that of the list. */
export function statusOfRun(run: RunSummary & { document?: Table | null }): Verdict | undefined {
  return verdictOf(run.document)?.status ?? run.status ?? undefined;
}

/** The status of one item of the scope, such as "left flank"; undefined where it was not judged or is not named. */
export function statusOfItem(verdict: StatedVerdict | undefined, item: string): Verdict | undefined {
  return verdict?.judged.find((some) => some.item === item)?.status;
}
