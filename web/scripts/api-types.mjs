// Makes src/api/generated.ts from src/api/openapi.json, the description of the interface as the server tells it. With --check nothing is
// written, and a file that is out of date is an error.
import { readFile, writeFile } from "node:fs/promises";
import openapiTS, { astToString } from "openapi-typescript";
import * as prettier from "prettier";
import ts from "typescript";

const source = new URL("../src/api/openapi.json", import.meta.url);
const target = new URL("../src/api/generated.ts", import.meta.url);
const HEADER = `// Made from openapi.json by \`npm run types\`; not edited.

import type { Json, Table } from "../lib/path";

`;

const named = (name) => ts.factory.createTypeReferenceNode(name);
const orNull = (node) => ts.factory.createUnionTypeNode([node, ts.factory.createLiteralTypeNode(ts.factory.createNull())]);

const number = () => ts.factory.createKeywordTypeNode(ts.SyntaxKind.NumberKeyword);

/** Any value and any object are the JSON of the pages; pairs and points keep the count of their numbers. */
function transform(schema) {
  if (schema.items?.type === "number" && [2, 3].includes(schema.minItems) && schema.minItems === schema.maxItems) {
    return ts.factory.createTupleTypeNode(Array.from({ length: schema.minItems }, number));
  }
  const keys = Object.keys(schema).filter((key) => key !== "description");
  if (keys.length === 0) return named("Json");
  if (keys.length > 1 || !("type" in schema)) return undefined;
  if (schema.type === "object") return named("Table");
  return JSON.stringify(schema.type) === '["object","null"]' ? orNull(named("Table")) : undefined;
}

const made = astToString(await openapiTS(source, { transform, defaultNonNullable: false }));
const options = await prettier.resolveConfig(target);
const text = await prettier.format(HEADER + made, { ...options, parser: "typescript" });
if (!process.argv.includes("--check")) await writeFile(target, text);
else if (text !== (await readFile(target, "utf8").catch(() => ""))) {
  console.error("src/api/generated.ts is not what openapi.json says; npm run types makes it");
  process.exit(1);
}
