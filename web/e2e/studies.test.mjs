// Studies and the catalogue: ratios judged side by side and taken over, bodies of the store put into the job.

import assert from "node:assert/strict";
import { button, heading, openExample, RUN_MS, useSite, valid } from "./page.mjs";
import { inRepository } from "./server.mjs";

const site = useSite();

async function openOther(page, name) {
  await button(page, "New").click();
  await page
    .getByRole("dialog")
    .getByRole("button", { name: new RegExp(`^${name}`) })
    .click();
  await page.getByRole("heading", { name, level: 1 }).waitFor();
  await valid(page);
}

site.test("a study is set up, run, and its choice taken over", async (page, server) => {
  await openExample(page, server, "twist-free-crowning");
  await page.goto(`${server.address}/#/explore`);
  await page.getByText("No study yet.").waitFor();
  await page.getByLabel("Diagonal ratio").check();
  const count = page.getByLabel("values", { exact: true });
  await count.fill("9");
  await count.blur();
  await page.waitForFunction(() => !document.querySelector("main .primary").disabled);
  await button(page, "Explore the open job").click();
  await page.locator("main circle").first().waitFor({ timeout: RUN_MS });
  assert.match(await page.locator("main .page-head").innerText(), /of 9 combinations allowed/);
  assert.equal(await page.locator("tbody tr").count(), 9);

  await page.locator("tbody tr").first().getByRole("button").click();
  const chosen = await page.locator("tbody tr").first().locator("td").nth(1).innerText();
  await page.getByRole("button", { name: "Use it in the open job" }).click();
  await page.getByText(/^planned in/).waitFor();
  const ratio = page.getByRole("textbox", { name: /Diagonal ratio/ });
  const number = (text) => Number(text.replace("−", "-"));
  assert.ok(Math.abs(number(await ratio.inputValue()) - number(chosen)) < 1e-3, `${await ratio.inputValue()} for ${chosen}`);
});

site.test("a combination is taken into the job that was studied, a refused one into none", async (page, server) => {
  const id = await server.run("explore", "twist-free-crowning");
  await openExample(page, server, "automotive-bias");
  await page.goto(`${server.address}/#/runs/${id}`);
  const apply = button(page, "Open the studied job with it");
  await page.locator("tbody tr").first().getByRole("button").click();
  await page.getByText("The open job is not the one that was studied").waitFor();
  const refused = page.locator("tbody tr.refused").first();
  await refused.getByRole("button").click();
  await page.getByText("This combination is refused and cannot be taken into the job.").waitFor();
  assert.ok(await apply.isDisabled(), "a refused combination can be applied");
  await page.locator("tbody tr").first().getByRole("button").click();
  await apply.click();
  await page.getByRole("heading", { name: "twist-free-crowning", level: 1 }).waitFor();
  await page.getByRole("button", { name: "Undo" }).click();
  await page.getByRole("heading", { name: "automotive-bias", level: 1 }).waitFor();
});

site.test("a study over the catalogue ranks its pairs with their units", async (page, server) => {
  const id = await server.run("explore", "catalogue");
  await page.goto(`${server.address}/#/runs/${id}`);
  await page.getByText("18 of 120 pairs make the profile").waitFor();
  const ranking = page.locator("table", { has: page.getByRole("columnheader", { name: "Rank" }) });
  assert.match(await ranking.locator("tbody tr").first().innerText(), /^1\sW3-03\sD120-3-200\/3\s3\s%\s.*196\.25\smm/);
  const all = await page.locator("table", { hasText: "W7-01" }).first().locator("td").allTextContents();
  assert.equal(all.length, 120);
  assert.equal(all.filter((text) => text.startsWith("✓")).length, 18);
  await page.getByLabel("only allowed ones").check();
  assert.equal(await ranking.locator("tbody tr").count(), 18);
});

site.test("a study with a free diameter tells the ranges of every pair, a study of dressing its curves", async (page, server) => {
  const free = await server.run("explore", "catalogue-free-diameter");
  await page.goto(`${server.address}/#/runs/${free}`);
  await page.getByText("58 of 120 pairs make the profile").waitFor();
  await page.getByRole("cell", { name: "169.98\u202fmm" }).waitFor();
  const dressing = await server.run("explore", "dressing/figure-06");
  await page.goto(`${server.address}/#/runs/${dressing}`);
  await page.locator("main .chart svg").first().waitFor();
  await heading(page, "Worm and dresser of the job").waitFor();
});

site.test("ranks stand on paper, controls do not", async (page, server) => {
  const id = await server.run("explore", "twist-free-crowning");
  await page.goto(`${server.address}/#/runs/${id}`);
  await page.locator("tbody tr").first().waitFor();
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("tbody tr td").first().innerText(), "1");
  assert.equal(await page.locator("button:visible, .button:visible, input:visible, select:visible").count(), 0);
});

site.test("only what a job can begin is offered", async (page, server) => {
  await openExample(page, server, "twist-free-crowning");
  assert.ok(await button(page, "Simulate").isDisabled(), "a job without settings could be simulated");
  assert.ok(await button(page, "Explore").isEnabled());
  await openOther(page, "worn-tool");
  assert.ok(await button(page, "Simulate").isEnabled());
  assert.ok(await button(page, "Explore").isDisabled());
  await page.goto(`${server.address}/#/explore`);
  await page.getByText("only jobs of generating grinding can be explored").waitFor();
  assert.ok(await button(page, "Explore the open job").isDisabled());
});

site.test("an empty catalogue says how it is filled", async (page, server) => {
  await page.goto(`${server.address}/#/catalogue`);
  await page.getByText("The store has no worms or dressers yet.").waitFor();
});

site.test("a body of the catalogue is found and put into the job", async (page, server) => {
  await server.command("store", "catalogue", "add", inRepository("examples/catalogue/bodies.toml"));
  await openExample(page, server, "twist-free-crowning");
  await page.keyboard.press("Alt+Shift+Digit5");
  await heading(page, "Worms").waitFor();
  await page.getByRole("searchbox", { name: "Filter" }).fill("W3-02");
  const row = page.getByRole("row", { name: /W3-02/ });
  await row.getByRole("button", { name: "Use in the open job" }).click();
  await page.getByText("W3-02 is in the open job now.").waitFor();
  await page.getByRole("tab", { name: "Worm", exact: true }).click();
  await page.waitForFunction(() => document.querySelector("#field-worm-tip_diameter")?.value === "184");
});
