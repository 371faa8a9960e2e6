// Places in the text of a job, and the least change between two texts.

import type { Finding } from "../api/types";
import { parsePath, type Path } from "../lib/path";

export interface TextChange {
  from: number;
  to: number;
  insert: string;
}

/** The change that makes one text the other, leaving what both begin and end with. */
export function changeBetween(before: string, after: string): TextChange | undefined {
  if (before === after) return undefined;
  let from = 0;
  const shorter = Math.min(before.length, after.length);
  while (from < shorter && before[from] === after[from]) from++;
  let tail = 0;
  while (tail < shorter - from && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail++;
  return { from, to: before.length - tail, insert: after.slice(from, after.length - tail) };
}

/** Where a finding stands in the text: its offsets, else from its column to the end of its line, else the beginning. */
export function rangeOfFinding(text: string, finding: Finding): { from: number; to: number } {
  if (typeof finding.start === "number") {
    const from = Math.min(finding.start, text.length);
    return { from, to: Math.min(Math.max(finding.end ?? from, from), text.length) };
  }
  if (!finding.line || finding.file) return { from: 0, to: 0 };
  let start = 0;
  for (let line = 1; line < finding.line; line++) {
    const end = text.indexOf("\n", start);
    if (end < 0) return { from: text.length, to: text.length };
    start = end + 1;
  }
  const end = text.indexOf("\n", start);
  const last = end < 0 ? text.length : end;
  return { from: Math.min(start + (finding.column ?? 1) - 1, last), to: last };
}

/** Whether a text looks like a job rather than a table or a machine. */
export function looksLikeJob(name: string, text: string): boolean {
  if (/\.json$/i.test(name)) return /"job"\s*:/.test(text);
  return /\.toml$/i.test(name) && /^\s*\[job\]|^\s*job\s*=|^\s*job\./m.test(text);
}

/** Names of files that a job speaks of: values of keys that end like file names and lie beside it. */
export function namedFiles(value: unknown): string[] {
  if (typeof value === "string") return /^[^/\\\s]+\.(csv|toml|json|jsonl|txt)$/i.test(value) ? [value] : [];
  if (Array.isArray(value)) return value.flatMap(namedFiles);
  if (typeof value === "object" && value !== null) return Object.values(value).flatMap(namedFiles);
  return [];
}

/**
 * Findings on another writing of the job, such as the JSON that a page sends: their places are taken to the lines of the user's text.
 */
export function atOwnLines(findings: Finding[], text: string): Finding[] {
  return findings.map((finding) => {
    if (finding.file) return finding;
    const { line: _, column: __, start: ___, end: ____, ...rest } = finding;
    const line = finding.field ? lineOfField(text, parsePath(finding.field)) : undefined;
    return line === undefined ? rest : { ...rest, line };
  });
}

/** The line of a TOML text, from 1, on which an entry stands: its own, else that of the nearest table or list around it. */
export function lineOfField(text: string, path: Path): number | undefined {
  const wanted = path.map(String);
  const counts = new Map<string, number>();
  let table: string[] = [];
  let best: { line: number; depth: number } | undefined;
  const offer = (at: string[], line: number): void => {
    const isAround = at.length <= wanted.length && at.every((step, k) => step === wanted[k]);
    if (isAround && at.length > (best?.depth ?? 0)) best = { line, depth: at.length };
  };
  text.split("\n").forEach((written, number) => {
    const [, lists, tables] = /^\s*(?:\[\[([^\]]+)\]\]|\[([^\]]+)\])\s*(?:#.*)?$/.exec(written) ?? [];
    const heading = lists ?? tables;
    if (heading !== undefined) {
      table = withPlaces(stepsOf(heading), counts, lists !== undefined);
      offer(table, number + 1);
      return;
    }
    const [, key, value] =
      /^\s*((?:"[^"]*"|'[^']*'|[A-Za-z0-9_-]+)(?:\s*\.\s*(?:"[^"]*"|'[^']*'|[A-Za-z0-9_-]+))*)\s*=(.*)$/.exec(written) ?? [];
    if (key === undefined || value === undefined) return;
    offer([...table, ...stepsOf(key)], number + 1);
  });
  return best?.line;
}

const stepsOf = (key: string): string[] => key.split(".").map((step) => step.trim().replace(/^["']|["']$/g, ""));

/** A heading with the index of each list of tables on its way: `[[target.modifications]]` for the second time is `target.modifications.1`. */
function withPlaces(heading: string[], counts: Map<string, number>, isList: boolean): string[] {
  const steps: string[] = [];
  heading.forEach((step, at) => {
    steps.push(step);
    const name = steps.join(".");
    if (isList && at === heading.length - 1) counts.set(name, (counts.get(name) ?? -1) + 1);
    const place = counts.get(name);
    if (place !== undefined) steps.push(String(place));
  });
  return steps;
}
