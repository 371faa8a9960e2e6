// The server is killed in the middle of a run: the page says so, lists the run as interrupted, and begins it again.

import assert from "node:assert/strict";
import { button, heading, openExample, RUN_MS, useSite } from "./page.mjs";

const site = useSite();

site.test(
  "a killed server is told, and its run can be begun again",
  async (page, server) => {
    await openExample(page, server, "catalogue-free-diameter");
    await button(page, "Explore").click();
    await page.locator("main progress[value]").waitFor();
    const id = page.url().match(/runs\/(\d+)/)[1];
    await server.kill();
    await page.getByText("The server does not answer.").waitFor();
    await page.getByText("See whether “flankwright serve” is still running").waitFor();

    await server.startAgain();
    // The page asks again by itself.
    await heading(page, "The server ended while this run was under way.").waitFor();
    await page.getByText("The server does not answer.").waitFor({ state: "detached" });
    await page.getByRole("link", { name: "All runs" }).click();
    const row = page.locator("tr", { has: page.locator(`a[href="#/runs/${id}"]`) });
    await row.getByText("interrupted").waitFor();
    assert.equal((await server.get(`runs/${id}`)).state, "interrupted");

    await page.locator(`a[href="#/runs/${id}"]`).click();
    await button(page, "Run again").click();
    await page.waitForURL((url) => /runs\/\d+/.test(url.hash) && !url.hash.endsWith(`/${id}`));
    await page.getByRole("tab", { name: "Study" }).waitFor({ timeout: RUN_MS });
    await page.locator("main .panel").first().waitFor();
  },
  { allowed: [/ERR_CONNECTION_REFUSED|ERR_CONNECTION_RESET|ERR_INCOMPLETE_CHUNKED_ENCODING|ERR_EMPTY_RESPONSE/] },
);

site.test(
  "without a server a job can be edited on and is kept",
  async (page, server) => {
    await openExample(page, server, "hob");
    await server.kill();
    await page.locator(".cm-line", { hasText: "teeth = " }).first().click();
    await page.keyboard.press("End");
    await page.keyboard.type(" # mine");
    await page.getByText("The server does not answer.").waitFor();
    await page.getByText("Not checked").waitFor();
    assert.ok(await button(page, "Prove with the referee").isDisabled());
    await server.startAgain();
    await button(page, "Try again").click();
    await page.locator('[data-state="valid"]').waitFor();
    assert.match(await page.locator(".cm-content").innerText(), /# mine/);
  },
  { allowed: [/ERR_CONNECTION_REFUSED|ERR_CONNECTION_RESET|ERR_EMPTY_RESPONSE/] },
);
