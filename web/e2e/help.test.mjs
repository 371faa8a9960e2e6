// German help: there is a text for everything that the schema of jobs says and for nothing else, and the form shows it.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { openExample, picture, useSite } from "./page.mjs";
import { inRepository } from "./server.mjs";

const site = useSite();

/** Every description in a schema, in one line. */
function* descriptions(schema) {
  if (typeof schema !== "object" || schema === null) return;
  if (typeof schema.description === "string") yield schema.description.replaceAll("\n", " ");
  for (const inner of Object.values(schema)) yield* descriptions(inner);
}

test("every description of the schema has a German text, and no text is left over", async () => {
  const german = JSON.parse(await readFile(inRepository("web/src/texts/help-de.json"), "utf8"));
  const english = new Set(descriptions(await site.server.get("schema")));
  const missing = [...english].filter((text) => !german[text]);
  const leftOver = Object.keys(german).filter((text) => !english.has(text));
  assert.deepEqual({ missing, leftOver }, { missing: [], leftOver: [] });
});

site.test("help follows the language", async (page, server) => {
  const loaded = [];
  page.on("request", (request) => loaded.push(request.url()));
  const isLoaded = () => loaded.some((url) => url.includes("help-de"));
  await openExample(page, server, "twist-free-crowning");
  await page.getByRole("tab", { name: "Grinding", exact: true }).click();
  await page.getByText("Number of areas of the worm used one after the other.").waitFor();
  assert.ok(!isLoaded(), "English pages load German help");
  await page.getByRole("button", { name: "Language: de" }).click();
  await page.getByText("Anzahl der nacheinander genutzten Bereiche der Schnecke.").waitFor();
  assert.ok(isLoaded());
  // Words say what they mean, tables to add and shapes of a value what they are.
  await page.getByText("Die Schnecke shiftet während des Vorschubs längs ihrer Achse.").waitFor();
  await page.locator('option:has-text("Ein Shift, der kein Vielfaches des Vorschubs ist")').waitFor({ state: "attached" });
  await page.locator('option[title^="Die Steuerung, die die Achsen koppelt"]').waitFor({ state: "attached" });
  await picture(page, "German help");
  await page.getByRole("tab", { name: "Sollflanke" }).click();
  await page.getByText("Parabolische Breitenballigkeit über die Zahnbreite.").first().waitFor();
});
