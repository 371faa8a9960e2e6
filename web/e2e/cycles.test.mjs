// Cycles from stock to cost, as a process engineer goes through them: opened, planned, proved, read on page one of the report and in its
// pictures.

import assert from "node:assert/strict";
import { button, openExample, RUN_MS, tab, useSite, verdict } from "./page.mjs";

const site = useSite();
/** Examples by their job's name. */
const CYCLES = ["ev-gear-cycle", "truck-gear-cycle", "spur-gear-cycle"];

for (const name of CYCLES) {
  site.test(`${name} is planned, proved and handed on`, async (page, server) => {
    await openExample(page, server, name);
    await button(page, "Plan").click();
    await page.getByText(/^planned in/).waitFor();
    await button(page, "Prove with the referee").click();
    await verdict(page, "met", RUN_MS);
    const id = page.url().match(/runs\/(\d+)/)[1];

    await tab(page, "Report").click();
    const report = page.frameLocator('iframe[title="Report"]');
    const first = await report.locator(".first.sheet").innerText();
    for (const said of ["cost per part", "parts per dressing", "normal tooth thickness", "feed"]) {
      assert.ok(first.includes(said), `page one says nothing of "${said}"`);
    }
    for (const chart of ["removal-rate-over-time", "specific-removal-rate-1", "load-of-the-worm", "time-over-load"]) {
      await report.locator(`[data-chart="${chart}"] svg`).first().waitFor({ state: "attached" });
    }

    // The same figures in the document.
    const { removal, status } = JSON.parse((await server.bytes(`runs/${id}/files/result.json`)).toString());
    assert.equal(status, "met");
    assert.ok(removal.part_time.part_s > removal.part_time.grinding_s && removal.cost_per_part.total > 0);
    assert.ok(Math.abs(removal.part_time.grinding_by_law_s / removal.part_time.grinding_s - 1) < 0.01);
  });
}
