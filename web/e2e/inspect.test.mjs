// Inspection: measurements dropped with and without their job, the sheet, what is systematic, the corrected job, and what the store keeps.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { button, drop, heading, RUN_MS, tab, useSite, valid, verdict } from "./page.mjs";
import { exampleText, inRepository } from "./server.mjs";

const site = useSite();

async function openInspection(page, server) {
  await page.goto(`${server.address}/#/inspect`);
  await page.getByRole("heading", { name: "Inspection", level: 1 }).waitFor();
}

site.test("a table without a job says what it needs", async (page, server) => {
  await openInspection(page, server);
  await drop(page, ".zone", [{ name: "measured.csv", text: await exampleText("inspection/measured.csv") }]);
  await page.getByText("A CSV table says nothing of the gear, so it needs a job.").waitFor();
  assert.ok(await button(page, "Evaluate").isDisabled());
  // Tables make no series, with or without a job.
  await drop(page, ".zone", [{ name: "again.csv", text: await exampleText("inspection/measured.csv") }]);
  await page.getByText("CSV tables are evaluated one at a time").waitFor();
  await page.getByRole("button", { name: "Remove again.csv" }).click();
  await page.getByText("CSV tables are evaluated one at a time").waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Remove measured.csv" }).click();
  await page.getByText("measured.csv").waitFor({ state: "detached" });
});

site.test("a measurement dropped with its job is judged, explained and corrected", async (page, server) => {
  await openInspection(page, server);
  await drop(page, ".zone", [
    { name: "measured.toml", text: await exampleText("inspection/measured.toml") },
    { name: "measured.csv", text: await exampleText("inspection/measured.csv") },
  ]);
  assert.ok(await page.getByLabel("a job file: measured.toml").isChecked());
  await page.getByLabel("Tolerance class").selectOption("5");
  await button(page, "Evaluate").click();
  await verdict(page, "missed", RUN_MS);

  await tab(page, "Sheet").click();
  const frame = page.locator('iframe[title="Inspection sheet"]');
  assert.equal(await frame.getAttribute("sandbox"), "");
  await frame.contentFrame().locator("svg").first().waitFor();

  await tab(page, "Systematic part").click();
  await page.getByRole("cell", { name: "correct it" }).first().waitFor();
  await heading(page, "Proposed corrections").waitFor();
  const rows = page.locator("table", { hasText: "What the referee says this leaves" }).locator("tbody tr");
  assert.ok((await rows.count()) > 0, "the referee says nothing of the correction");

  await button(page, "Open the corrected job").click();
  await heading(page, "measured").waitFor();
  await valid(page);
  const id = (await server.get("runs?most=1"))[0].id;
  const corrected = (await server.bytes(`runs/${id}/files/corrected-job.json`)).toString();
  const shown = await page.locator(".cm-content").innerText();
  assert.ok(corrected.startsWith(shown.split("\n").slice(0, 5).join("\n")), "the editor shows another job");
});

site.test("files of several parts make a series, whose parts the store keeps", async (page, server) => {
  await openInspection(page, server);
  // The parts of one drawing, and a file that is damaged.
  const text = await readFile(inRepository("fuzz/seeds/klingelnberg/curves.mka"), "latin1");
  await drop(page, ".zone", [
    ...["4711", "4712", "4713"].map((part) => ({ name: `${part}.mka`, text: text.replaceAll("4711", part) })),
    { name: "damaged.mka", text: text.slice(0, 300) },
  ]);
  await page.getByLabel("Keep the parts in the store").check();
  await page.getByLabel("Series", { exact: true }).fill("morning");
  await button(page, "Evaluate").click();
  await page.getByRole("cell", { name: "4713.mka", exact: true }).waitFor({ timeout: RUN_MS });
  await heading(page, "Refused files").waitFor();
  await page.locator("li", { hasText: "damaged.mka" }).first().waitFor();
  await heading(page, "In the store").waitFor();
  await page.locator("li", { hasText: "kept in the series morning" }).nth(2).waitFor();
  await page.locator("li", { hasText: "damaged.mka: not kept" }).waitFor();
  await tab(page, "Sheet").click();
  await page.locator("main select option").nth(2).waitFor({ state: "attached" });
  await page.frameLocator("iframe").locator("svg").first().waitFor();

  await page.goto(`${server.address}/#/history/parts`);
  await page.getByRole("cell", { name: "morning" }).nth(2).waitFor();
  await page.locator("tbody a").first().click();
  await page.locator("main dl").first().waitFor();
  await tab(page, "Trend").click();
  await page.getByLabel("Series").selectOption("morning");
  await page.locator("main svg circle.first").nth(2).waitFor();
  await page.getByLabel("Characteristic").selectOption("fHa");
  await page.locator("main svg text", { hasText: "fHα" }).waitFor();
  await page.getByLabel("Flank").selectOption("right");
  await page.waitForFunction(() => document.querySelectorAll("tbody tr").length === 3);
  await page.locator("tbody a").first().click();
  await page.locator("main dl").first().waitFor();
});

site.test("a blank gets the table of its stock, from a file and from the store", async (page, server) => {
  // The job knows the mean stock, and has no table yet.
  const job = (await exampleText("cycles/measured-blank.toml")).replace(/^map = .*\n/m, "");
  await openInspection(page, server);
  await drop(page, ".zone", [
    { name: "measured-blank.toml", text: job },
    { name: "blank.csv", text: await exampleText("inspection/blank.csv") },
  ]);
  await page.getByLabel("It is the blank before grinding").check();
  await button(page, "Evaluate").click();
  await heading(page, "Stock of the blank over the gear of the job").waitFor({ timeout: RUN_MS });
  await page.getByText("Level from the job: stock.allowance_um").waitFor();
  const [table] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("link", { name: "Download the table (stock.csv)" }).click(),
  ]);
  assert.equal(table.suggestedFilename(), "stock.csv");
  assert.match(await readFile(await table.path(), "utf8"), /^flank,space,w_mm,z_mm,um\n/);

  // A stored part is offered to the open job; this one is another gear, which is told.
  await openInspection(page, server);
  const text = await readFile(inRepository("fuzz/seeds/klingelnberg/curves.mka"), "latin1");
  await drop(page, ".zone", [{ name: "kept.mka", text: text.replaceAll("4711", "4799") }]);
  await page.getByLabel("Keep the parts in the store").check();
  await button(page, "Evaluate").click();
  await heading(page, "In the store").waitFor({ timeout: RUN_MS });
  await page.goto(server.address);
  await page.getByRole("button", { name: /^closed-loop/ }).click();
  await valid(page);
  await page.goto(`${server.address}/#/history/parts`);
  await page.locator("tbody tr", { hasText: "kept.mka" }).locator("a").click();
  await page.getByRole("button", { name: /^Stock as a blank of/ }).click();
  await page.getByText("the measurement is of another gear").first().waitFor({ timeout: RUN_MS });
});

site.test("a job that simulates its measurement is inspected without a file", async (page, server) => {
  await page.goto(server.address);
  await page.getByRole("button", { name: /^closed-loop/ }).click();
  await valid(page);
  await page.goto(`${server.address}/#/inspect`);
  await button(page, "Evaluate: closed-loop").click();
  await verdict(page, "met", RUN_MS);
  await tab(page, "Systematic part").click();
  await heading(page, "Round 2").waitFor();
});

site.test("recent inspections are listed", async (page, server) => {
  const id = await server.run("inspect", "inspection/closed-loop");
  await openInspection(page, server);
  await page.locator(`a[href="#/runs/${id}"]`).click();
  await heading(page, "closed-loop").waitFor();
});
