// Runs: cancelled, followed over a reload, listed, begun again, deleted, compared; and failures with what to do about them.

import assert from "node:assert/strict";
import { button, heading, openExample, RUN_MS, tab, useSite } from "./page.mjs";

const site = useSite();
/** A study that takes long enough to be looked at meanwhile. */
const LONG = "catalogue-free-diameter";
/** The element of a progress bar that has come some way. */
const onItsWay = (page) => page.locator("main progress[value]").waitFor();

async function startLong(page, server) {
  await openExample(page, server, LONG);
  await button(page, "Explore").click();
  await page.getByRole("heading", { name: /^Stage:/ }).waitFor();
  await onItsWay(page);
  return page.url().match(/runs\/(\d+)/)[1];
}

site.test("a run is cancelled", async (page, server) => {
  const id = await startLong(page, server);
  await button(page, "Cancel").click();
  await heading(page, "This run was cancelled.").waitFor();
  assert.equal((await server.get(`runs/${id}`)).state, "cancelled");
  await page.getByRole("link", { name: "All runs" }).click();
  const row = page.locator("tr", { has: page.locator(`a[href="#/runs/${id}"]`) });
  await row.getByText("cancelled").waitFor();
});

site.test("a run goes on over a reload and can be cancelled in the list", async (page, server) => {
  const id = await startLong(page, server);
  const seen = Number(await page.locator("main progress").getAttribute("value"));
  await page.reload();
  await page.getByRole("heading", { name: /^Stage:/ }).waitFor();
  await page.waitForFunction((seen) => document.querySelector("main progress")?.value > seen, seen);
  assert.equal((await server.get(`runs/${id}`)).state, "running");
  // The draft is there as well, and the rail counts the run.
  await page.locator("nav .count", { hasText: "1" }).waitFor();
  await page.keyboard.press("Alt+Shift+Digit1");
  await heading(page, LONG).waitFor();
  await page.keyboard.press("Alt+Shift+Digit2");
  await page.getByRole("button", { name: `Cancel ${id}` }).click();
  const row = page.locator("tr", { has: page.locator(`a[href="#/runs/${id}"]`) });
  await row.getByText("cancelled").waitFor();
});

site.test("runs are found, begun again and deleted in the list", async (page, server) => {
  const id = await server.run("plan", "hob");
  await server.run("plan", "dressing/two-flanks");
  await page.goto(`${server.address}/#/runs`);
  const rows = page.locator("tbody tr");
  await page.locator(`a[href="#/runs/${id}"]`).waitFor();
  await page.getByRole("searchbox", { name: "Filter by name" }).fill("HOB");
  await page.waitForFunction(() => [...document.querySelectorAll("tbody tr")].every((row) => row.innerText.includes("hob")));
  const before = await rows.count();
  await page.getByRole("button", { name: `Run again ${id}` }).click();
  await page.waitForFunction((before) => document.querySelectorAll("tbody tr").length === before + 1, before);
  await rows.first().locator("span.met").waitFor();
  await page.getByRole("button", { name: `Delete ${id}` }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Delete" }).click();
  await page.locator(`a[href="#/runs/${id}"]`).waitFor({ state: "detached" });
  assert.ok(!(await server.get("runs?most=100")).some((run) => run.id === id));
  await page.getByLabel("Kind").selectOption("explore");
  await page.waitForFunction(() => document.querySelectorAll("tbody tr").length === 0);
});

site.test(
  "a run that is gone says so and leads to the list",
  async (page, server) => {
    await page.goto(`${server.address}/#/runs/9999`);
    await page.getByText("This is not there (any more).").waitFor();
    await page.getByRole("link", { name: "All runs" }).click();
    await heading(page, "Runs").waitFor();
  },
  { allowed: [/status of 404/] },
);

site.test("a run that fails tells why, and opens its job", async (page, server) => {
  const id = await server.run("simulate", "twist-free-crowning");
  await page.goto(`${server.address}/#/runs/${id}`);
  await heading(page, "This run failed.").waitFor();
  await page.getByText("Bad input").waitFor();
  await page.getByText("plan the job first").waitFor();
  await button(page, "Open its job").click();
  await heading(page, "twist-free-crowning").waitFor();
});

site.test("two runs stand side by side with their difference", async (page, server) => {
  const first = await server.run("plan", "twist-free-crowning");
  const second = await server.run("plan", "twist-free-crowning", (text) => text.replace("amount_um = 20.0", "amount_um = 18.0"));
  await page.goto(`${server.address}/#/runs/${first}`);
  await page.getByRole("link", { name: "Compare with another" }).click();
  await page.getByText("Choose two runs that are done.").waitFor();
  assert.equal(await page.getByLabel("Second result").inputValue(), "-");
  await page.getByLabel("Second result").selectOption(String(second));
  await page.locator("figure canvas").nth(5).waitFor();
  assert.equal(await page.locator("figure").count(), 6, "two results and their difference for each flank");
  const crowning = page.locator('tr:has(td[title="flanks.left.target_characteristics.helix_crowning_um"])');
  const values = (await crowning.locator("td").allTextContents())
    .slice(1)
    .map((text) => Number.parseFloat(text.replace("−", "-")));
  assert.ok(Math.abs(values[1] - values[0] - values[2]) < 0.01 && Math.abs(values[2] + 2) < 0.1, `crowning ${values}`);
  await page.getByRole("button", { name: "Exchange" }).click();
  await page.waitForURL(`**/#/compare/${second}/${first}`);
  await page
    .locator("figure strong", { hasText: `${first} − ${second}` })
    .first()
    .waitFor();
});

site.test("the tabs of a run show what they name", async (page, server) => {
  const id = await server.run("plan", "twist-free-crowning");
  await page.goto(`${server.address}/#/runs/${id}`);
  await page.locator("main .bar").first().waitFor({ timeout: RUN_MS });
  await tab(page, "Flank").click();
  await page.locator("figure canvas").nth(1).waitFor();
  await tab(page, "3D net").click();
  await page.locator(".net .label").first().waitFor();
  await tab(page, "Charts").click();
  await page.locator("main .chart svg").first().waitFor();
  await tab(page, "Numbers").click();
  await page.locator("main details").first().waitFor();
  await tab(page, "Report").click();
  const report = page.frameLocator('iframe[title="Report"]');
  await report
    .getByRole("heading", { name: /twist-free-crowning/ })
    .first()
    .waitFor();
  await tab(page, "Files").click();
  const names = (await server.get(`runs/${id}`)).files.map((file) => file.name);
  assert.deepEqual(await page.locator("main td a").allTextContents(), names);
});
