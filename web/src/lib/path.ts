// Paths into a job: a key for a table, an index for a list. Reading and changing values there.

export type Step = string | number;
export type Path = Step[];
export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type Table = { [key: string]: Json };

export function isTable(value: unknown): value is Table {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** A table of what is there. */
export function withoutAbsent(table: { [key: string]: Json | undefined }): Table {
  return Object.fromEntries(Object.entries(table).flatMap(([key, value]) => (value == null ? [] : [[key, value]])));
}

/** A path as findings write it: `target.modifications[0].amount_um`. */
export function pathText(path: Path): string {
  return path.map((step, at) => (typeof step === "number" ? `[${step}]` : at === 0 ? step : `.${step}`)).join("");
}

/** The path that a finding's field stands for; indices may stand in brackets or between points. */
export function parsePath(field: string): Path {
  return field
    .replace(/\[(\d+)\]/g, ".$1")
    .split(".")
    .filter((step) => step !== "")
    .map((step) => (/^\d+$/.test(step) ? Number(step) : step));
}

/** Whether `path` is `prefix` or lies below it. */
export function startsWith(path: Path, prefix: Path): boolean {
  return prefix.every((step, at) => String(path[at]) === String(step));
}

/** The value at a path, undefined where there is none. */
export function valueAt(tree: Json | undefined, path: Path): Json | undefined {
  let value: Json | undefined = tree;
  for (const step of path) {
    if (Array.isArray(value) && typeof step === "number") value = value[step];
    else if (isTable(value)) value = value[String(step)];
    else return undefined;
  }
  return value;
}

/** A copy of the tree with the value at a path set, or taken out where it is undefined; tables on the way are made. */
export function withValue(tree: Json, path: Path, value: Json | undefined): Json {
  const [step, ...rest] = path;
  if (step === undefined) return value ?? null;
  if (typeof step === "number") {
    const list = Array.isArray(tree) ? [...tree] : [];
    if (rest.length === 0 && value === undefined) list.splice(step, 1);
    else list[step] = withValue(list[step] ?? null, rest, value);
    return list;
  }
  const table: Table = isTable(tree) ? { ...tree } : {};
  if (rest.length === 0 && value === undefined) delete table[step];
  else table[step] = withValue(table[step] ?? null, rest, value);
  return table;
}
