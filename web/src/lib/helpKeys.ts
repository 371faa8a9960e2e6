// Keys of help: where a description stands in the schema, in names that do not change with its words. A definition has its name, an entry
// `Gear.teeth`, a word `Hand=left`, a kind `Modification.kind=twist`, another variant `Ratio|number`. `crates/words` makes the same keys
// and holds the German texts to them.

import type { Schema } from "./schema";

/** The key of what the schema says about the whole file. */
const ROOT = "job file";

/** The schema with the key of every description beside it, as `x-help`. */
export function withHelpKeys(schema: Schema, key = ""): Schema {
  const keyed: Schema = { ...schema };
  if (schema.description !== undefined) keyed["x-help"] = key === "" ? ROOT : key;
  if (schema.$defs) keyed.$defs = mapped(schema.$defs, (inner, name) => withHelpKeys(inner, name));
  if (schema.properties) {
    keyed.properties = mapped(schema.properties, (inner, name) => withHelpKeys(inner, key === "" ? name : `${key}.${name}`));
  }
  if (schema.items) keyed.items = withHelpKeys(schema.items, `${key}[]`);
  if (schema.prefixItems) keyed.prefixItems = schema.prefixItems.map((inner, at) => withHelpKeys(inner, `${key}[${at}]`));
  if (typeof schema.additionalProperties === "object") {
    keyed.additionalProperties = withHelpKeys(schema.additionalProperties, `${key}.*`);
  }
  const variants = (list: Schema[]) => list.map((inner) => withHelpKeys(inner, key + variantKey(inner)));
  if (schema.oneOf) keyed.oneOf = variants(schema.oneOf);
  if (schema.anyOf) keyed.anyOf = variants(schema.anyOf);
  return keyed;
}

/** What distinguishes a variant from its siblings. */
function variantKey(variant: Schema): string {
  if (variant.const !== undefined) return `=${String(variant.const)}`;
  if (variant.$ref !== undefined) return `|${variant.$ref.split("/").at(-1)}`;
  const tag = Object.entries(variant.properties ?? {}).find(([, schema]) => schema.const !== undefined);
  if (tag) return `.${tag[0]}=${String(tag[1].const)}`;
  const keys = variant.required ?? Object.keys(variant.properties ?? {});
  if (variant.properties) return `{${[...keys].sort().join(",")}}`;
  return `|${variant.type ?? ""}`;
}

function mapped(schemas: Record<string, Schema>, change: (schema: Schema, name: string) => Schema): Record<string, Schema> {
  return Object.fromEntries(Object.entries(schemas).map(([name, schema]) => [name, change(schema, name)]));
}
