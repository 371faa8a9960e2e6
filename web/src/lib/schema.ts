// The form that a job schema describes: what control a value takes, its range, default and help. Children are made when asked for,
// since modifications contain modifications.

import { withHelpKeys } from "./helpKeys";
import type { Json, Table } from "./path";
import { isTable } from "./path";
import { unitOfKey } from "./units";

export interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  allOf?: Schema[];
  anyOf?: Schema[];
  oneOf?: Schema[];
  if?: Schema;
  then?: Schema;
  type?: string;
  const?: Json;
  enum?: Json[];
  properties?: Record<string, Schema>;
  required?: string[];
  additionalProperties?: boolean | Schema;
  unevaluatedProperties?: boolean;
  propertyNames?: Schema;
  items?: Schema;
  prefixItems?: Schema[];
  minItems?: number;
  maxItems?: number;
  uniqueItems?: boolean;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  minLength?: number;
  maxLength?: number;
  pattern?: string;
  default?: Json;
  description?: string;
  "x-way-out"?: string;
  /** The key of the description, see `helpKeys.ts`. */
  "x-help"?: string;
}

/** What a schema says about its value: in English, and the key of its translations. */
export interface Help {
  key: string;
  english: string;
}

export interface Range {
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
}

export interface Word {
  value: string;
  help: Help;
}

export type FormNode =
  | { type: "number"; integer: boolean; range: Range }
  | { type: "text" }
  | { type: "switch" }
  | { type: "word"; words: Word[] }
  | { type: "table"; schema: Schema }
  | { type: "kinds"; key: string; kinds: Word[]; schemas: Map<string, Schema> }
  | { type: "list"; item: Schema; least: number; most: number }
  | { type: "tuple"; items: Schema[] }
  | { type: "map"; item: Schema; pattern: string | undefined }
  | { type: "choice"; variants: Schema[] };

export interface Field {
  key: string;
  schema: Schema;
  required: boolean;
  help: Help;
  wayOut: string;
  standard: Json | undefined;
  unit: string;
}

export class JobSchema {
  readonly #root: Schema;

  constructor(root: Schema) {
    this.#root = withHelpKeys(root);
  }

  /** The schema of the jobs of a process; undefined for a process that is not known. */
  ofProcess(process: string): Schema | undefined {
    const rule = this.#root.allOf?.find((rule) => rule.if?.properties?.["job"]?.properties?.["process"]?.const === process);
    return rule?.then && this.resolve(rule.then);
  }

  /** The schema behind references; what stands beside a reference replaces what it says. */
  resolve(schema: Schema): Schema {
    if (schema.$ref === undefined) return schema;
    const target = this.#root.$defs?.[schema.$ref.replace("#/$defs/", "")];
    if (target === undefined) return {};
    const { $ref: _, ...beside } = schema;
    return { ...this.resolve(target), ...beside };
  }

  node(raw: Schema): FormNode {
    const schema = this.resolve(raw);
    const variants = (schema.oneOf ?? schema.anyOf)?.map((variant) => this.resolve(variant));
    if (variants) {
      const words = variants.map((variant) => this.#words(variant));
      if (words.every((some) => some.length > 0)) return { type: "word", words: words.flat() };
      const kinds = kindsOf(variants);
      return kinds ?? { type: "choice", variants };
    }
    const own = this.#words(schema);
    if (own.length > 0) return { type: "word", words: own };
    if (schema.type === "boolean") return { type: "switch" };
    if (schema.type === "number" || schema.type === "integer") {
      return { type: "number", integer: schema.type === "integer", range: rangeOf(schema) };
    }
    if (schema.type === "array") {
      if (schema.prefixItems) return { type: "tuple", items: schema.prefixItems };
      return { type: "list", item: schema.items ?? {}, least: schema.minItems ?? 0, most: schema.maxItems ?? Infinity };
    }
    if (schema.type === "object") {
      if (schema.properties) return { type: "table", schema };
      const item = typeof schema.additionalProperties === "object" ? schema.additionalProperties : {};
      return { type: "map", item, pattern: schema.propertyNames?.pattern };
    }
    return { type: "text" };
  }

  /** The entries of a table: those that are required first, otherwise in the order of the schema. */
  fields(schema: Schema, except?: string): Field[] {
    const required = new Set(schema.required ?? []);
    const fields = Object.entries(schema.properties ?? {})
      .filter(([key]) => key !== except)
      .map(([key, raw]) => {
        const resolved = this.resolve(raw);
        const numeric = hasNumber(resolved);
        return {
          key,
          schema: raw,
          required: required.has(key),
          help: helpOf(resolved),
          wayOut: resolved["x-way-out"] ?? "",
          standard: resolved.default,
          unit: unitOfKey(key, numeric),
        };
      });
    const order = schema.required ?? [];
    return fields.sort((a, b) => rank(a, order) - rank(b, order));
  }

  /** Which variant of a choice a value belongs to; the first where it fits none. */
  variantOf(variants: Schema[], value: Json | undefined): number {
    const at = variants.findIndex((variant) => this.#fits(this.node(variant), value));
    return Math.max(0, at);
  }

  /** A first value for an entry that is added. */
  start(raw: Schema): Json {
    const schema = this.resolve(raw);
    if (schema.default !== undefined) return schema.default;
    const node = this.node(schema);
    switch (node.type) {
      case "number":
        return startNumber(node.range);
      case "switch":
        return true;
      case "word":
        return node.words[0]?.value ?? "";
      case "text":
        return "";
      case "list":
        return Array.from({ length: node.least }, () => this.start(node.item));
      case "tuple":
        return node.items.map((item) => this.start(item));
      case "map":
        return {};
      case "choice":
        return this.start(node.variants[0] ?? {});
      case "kinds": {
        const first = node.kinds[0]?.value ?? "";
        return this.startKind(node, first);
      }
      case "table":
        return this.#startTable(node.schema);
    }
  }

  /** A first value of one kind of entry: what it requires. */
  startKind(node: FormNode & { type: "kinds" }, kind: string): Json {
    const schema = node.schemas.get(kind) ?? {};
    return { [node.key]: kind, ...this.#startTable(schema, node.key) };
  }

  #startTable(schema: Schema, except?: string): Table {
    const entries = this.fields(schema, except).filter((field) => field.required);
    return Object.fromEntries(entries.map((field) => [field.key, this.start(field.schema)]));
  }

  #words(schema: Schema): Word[] {
    const help = helpOf(schema);
    if (typeof schema.const === "string") return [{ value: schema.const, help }];
    if (schema.enum?.every((value) => typeof value === "string")) {
      return schema.enum.map((value) => ({ value: String(value), help: NO_HELP }));
    }
    const inner = schema.oneOf?.map((variant) => this.#words(this.resolve(variant)));
    return inner?.every((some) => some.length > 0) ? inner.flat() : [];
  }

  #fits(node: FormNode, value: Json | undefined): boolean {
    switch (node.type) {
      case "number":
        return typeof value === "number";
      case "switch":
        return typeof value === "boolean";
      case "word":
        return node.words.some((word) => word.value === value);
      case "text":
        return typeof value === "string";
      case "list":
      case "tuple":
        return Array.isArray(value);
      case "table": {
        if (!isTable(value)) return false;
        const known = node.schema.properties ?? {};
        const hasAll = (node.schema.required ?? []).every((key) => key in value);
        return hasAll && Object.keys(value).every((key) => key in known);
      }
      case "map":
      case "kinds":
        return isTable(value);
      case "choice":
        return node.variants.some((variant) => this.#fits(this.node(variant), value));
    }
  }
}

const NO_HELP: Help = { key: "", english: "" };

/** What a schema says about its value, in one line. */
export function helpOf(schema: Schema): Help {
  return { key: schema["x-help"] ?? "", english: (schema.description ?? "").replaceAll("\n", " ") };
}

function kindsOf(variants: Schema[]): (FormNode & { type: "kinds" }) | undefined {
  const key = Object.entries(variants[0]?.properties ?? {}).find(([, schema]) => typeof schema.const === "string")?.[0];
  if (key === undefined) return undefined;
  const schemas = new Map<string, Schema>();
  const kinds: Word[] = [];
  for (const variant of variants) {
    const value = variant.properties?.[key]?.const;
    if (typeof value !== "string") return undefined;
    schemas.set(value, variant);
    kinds.push({ value, help: helpOf(variant) });
  }
  return { type: "kinds", key, kinds, schemas };
}

function rangeOf(schema: Schema): Range {
  const { minimum, maximum, exclusiveMinimum, exclusiveMaximum } = schema;
  return Object.fromEntries(
    Object.entries({ minimum, maximum, exclusiveMinimum, exclusiveMaximum }).filter(([, value]) => value !== undefined),
  ) as Range;
}

function rank(field: Field, order: string[]): number {
  const at = order.indexOf(field.key);
  return at < 0 ? order.length : at;
}

function hasNumber(schema: Schema): boolean {
  if (schema.type === "number" || schema.type === "integer") return true;
  if (schema.type === "array") return schema.items ? hasNumber(schema.items) : false;
  return (schema.anyOf ?? schema.oneOf ?? []).some(hasNumber);
}

function startNumber(range: Range): number {
  const least = range.minimum ?? range.exclusiveMinimum ?? -Infinity;
  const most = range.maximum ?? range.exclusiveMaximum ?? Infinity;
  if (least < 0 && most > 0) return 0;
  if (range.minimum !== undefined) return range.minimum;
  return Number.isFinite(least) && least + 1 <= most ? least + 1 : 0;
}

/** Whether a number lies in a range. */
export function isInRange(value: number, range: Range): boolean {
  return (
    (range.minimum === undefined || value >= range.minimum) &&
    (range.maximum === undefined || value <= range.maximum) &&
    (range.exclusiveMinimum === undefined || value > range.exclusiveMinimum) &&
    (range.exclusiveMaximum === undefined || value < range.exclusiveMaximum)
  );
}

/** A range as text: `> 0, ≤ 5000`, `-90 < … < 90`. */
export function rangeText(range: Range, number: (value: number) => string = String): string {
  const low = range.minimum !== undefined ? `≥ ${number(range.minimum)}` : lowOpen(range, number);
  const high = range.maximum !== undefined ? `≤ ${number(range.maximum)}` : highOpen(range, number);
  return [low, high].filter((part) => part !== "").join(", ");
}

function lowOpen(range: Range, number: (value: number) => string): string {
  return range.exclusiveMinimum === undefined ? "" : `> ${number(range.exclusiveMinimum)}`;
}

function highOpen(range: Range, number: (value: number) => string): string {
  return range.exclusiveMaximum === undefined ? "" : `< ${number(range.exclusiveMaximum)}`;
}
