// German help in the form. That there is a text for every description of the schema is tested in crates/words.

import assert from "node:assert/strict";
import { openExample, picture, useSite } from "./page.mjs";

const site = useSite();

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
