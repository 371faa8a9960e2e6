// Places in the text of a job, and the least change between two texts.

import type { Finding } from "../api/types";

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
