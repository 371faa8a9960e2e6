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
  await page.getByRole("button", { name: /^Use this ratio in the open job/ }).click();
  await page.getByText(/^planned in/).waitFor();
  const ratio = page.getByRole("textbox", { name: /Diagonal ratio/ });
  const number = (text) => Number(text.replace("−", "-"));
  assert.ok(Math.abs(number(await ratio.inputValue()) - number(chosen)) < 1e-3, `${await ratio.inputValue()} for ${chosen}`);
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
  await page.keyboard.press("5");
  await heading(page, "Worms").waitFor();
  await page.getByRole("searchbox", { name: "Filter" }).fill("W3-02");
  const row = page.getByRole("row", { name: /W3-02/ });
  await row.getByRole("button", { name: "Use in the open job" }).click();
  await page.getByText("W3-02 is in the open job now.").waitFor();
  await page.getByRole("tab", { name: "Worm", exact: true }).click();
  await page.waitForFunction(() => document.querySelector("#field-worm-tip_diameter")?.value === "184");
});
