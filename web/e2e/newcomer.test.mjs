// A newcomer's path: from the first view over an example, its plan and its proof to the downloaded program.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { button, heading, limitMs, openExample, RUN_MS, tab, useSite, verdict } from "./page.mjs";

const site = useSite();

site.test("the first view comes within a second", async (page, server) => {
  const begun = performance.now();
  await page.goto(server.address);
  await heading(page, "Start a job").waitFor();
  await page.getByRole("button", { name: /^twist-free-crowning/ }).waitFor();
  const took = performance.now() - begun;
  console.log(`first view: ${took.toFixed(0)} ms`);
  assert.ok(took <= limitMs("FIRST_VIEW_MS", 1000), `the first view took ${took.toFixed(0)} ms`);
});

site.test("from an example to the downloaded program", async (page, server) => {
  await openExample(page, server, "twist-free-crowning");
  await button(page, "Plan").click();
  await page.getByText(/^planned in/).waitFor();
  await button(page, "Prove with the referee").click();
  await verdict(page, "met", RUN_MS);
  const names = await page.getByRole("tab").allTextContents();
  for (const name of ["Summary", "Flank", "Charts", "Programs", "Report", "Files", "Numbers"]) {
    assert.ok(names.includes(name), `no tab ${name} among ${names}`);
  }

  await tab(page, "Programs").click();
  await page.getByText("Axis travel").waitFor();
  const link = page.getByRole("link", { name: "Download" });
  const address = await link.getAttribute("href");
  const [download] = await Promise.all([page.waitForEvent("download"), link.click()]);
  const got = await readFile(await download.path());
  assert.equal(download.suggestedFilename(), address.split("/").at(-1));
  assert.ok(got.length > 1000, "the program is short");
  assert.deepEqual(got, await server.bytes(address.replace("/api/", "")));

  // The whole of it is shown as it is downloaded.
  await button(page, "Whole text").click();
  assert.equal(await page.locator("pre").textContent(), got.toString("utf8"));
});

site.test("all files of a run come as one archive", async (page, server) => {
  const id = await server.run("plan", "hob");
  await page.goto(`${server.address}/#/runs/${id}/files`);
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("link", { name: "All files as ZIP" }).click(),
  ]);
  assert.equal(download.suggestedFilename(), `hob-${id}.zip`);
  const got = await readFile(await download.path());
  assert.equal(got.subarray(0, 2).toString(), "PK");
});
