// The frame of all pages: language, light and dark, help, paper, the way back, and pages that do not exist.

import assert from "node:assert/strict";
import { button, heading, openExample, tab, useSite } from "./page.mjs";

const site = useSite();
const background = (page) => page.evaluate(() => getComputedStyle(document.querySelector("main")).getPropertyValue("--ground"));
const LIGHT = "#eef0f2";
const DARK = "#101317";

site.test("the language is switched and kept", async (page, server) => {
  await page.goto(server.address);
  await button(page, "Language: de").click();
  await heading(page, "Auftrag beginnen").waitFor();
  await page.getByRole("link", { name: "Auftrag" }).waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  await page.reload();
  await heading(page, "Auftrag beginnen").waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
});

site.test(
  "a German browser is served in German, with commas",
  async (page, server) => {
    await page.goto(server.address);
    await page.getByRole("button", { name: /^twist-free-crowning/ }).click();
    await page.getByRole("tab", { name: "Werkrad" }).click();
    await page.waitForFunction(() => document.querySelector("#field-gear-normal_module")?.value === "3,5");
    await page.locator("#field-gear-normal_module").fill("3,75");
    await page.waitForFunction(() => document.querySelector(".cm-content")?.innerText.includes("normal_module = 3.75"));
  },
  { locale: "de-DE" },
);

site.test("light and dark are switched and kept, and follow the system otherwise", async (page, server) => {
  await page.emulateMedia({ colorScheme: "dark" });
  await page.goto(server.address);
  await heading(page, "Start a job").waitFor();
  assert.equal(await background(page), DARK);
  await page.emulateMedia({ colorScheme: "light" });
  await page.locator('html[data-theme="light"]').waitFor();
  assert.equal(await background(page), LIGHT);
  await button(page, "Appearance: System").click();
  await button(page, "Appearance: Light").click();
  await page.locator('html[data-theme="dark"]').waitFor();
  await page.reload();
  await page.locator('html[data-theme="dark"]').waitFor();
  assert.equal(await background(page), DARK);
});

site.test("help opens by its key and gives the focus back", async (page, server) => {
  await page.goto(server.address);
  await heading(page, "Start a job").waitFor();
  const runs = page.getByRole("link", { name: "Runs" });
  await runs.focus();
  await page.keyboard.press("?");
  const help = page.getByRole("dialog", { name: "Keyboard shortcuts" });
  await help.getByText("Prove with the referee").waitFor();
  await page.keyboard.press("Escape");
  await help.waitFor({ state: "detached" });
  assert.ok(await runs.evaluate((link) => link === document.activeElement), "the focus is lost");
  // In a field it is a letter.
  await page.getByRole("searchbox").fill("");
  await page.getByRole("searchbox").press("?");
  assert.equal(await page.getByRole("dialog").count(), 0);
});

site.test("on paper stands the content alone, in light colours", async (page, server) => {
  const id = await server.run("plan", "twist-free-crowning");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.goto(`${server.address}/#/runs/${id}`);
  await page.locator("main .bar").first().waitFor();
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  assert.equal(await background(page), "#ffffff");
  assert.ok(await heading(page, "twist-free-crowning").isVisible());
  assert.equal(await page.locator("nav:visible, button:visible, [role='tab']:visible").count(), 0);
  // Nothing is cut off by an area that scrolls.
  const cut = await page.evaluate(
    () => [...document.querySelectorAll("main, main .page")].filter((some) => some.scrollHeight > some.clientHeight + 1).length,
  );
  assert.equal(cut, 0, "a part of the page would not be printed");
});

site.test("a job stands on paper with its whole text", async (page, server) => {
  await openExample(page, server, "twist-free-crowning");
  const { text } = await server.get("examples/twist-free-crowning");
  await page.emulateMedia({ media: "print" });
  const printed = page.locator("main pre:visible");
  assert.equal(await printed.textContent(), text);
  assert.equal(await page.locator(".cm-content:visible, button:visible, input:visible").count(), 0);
});

site.test("printing waits for charts that were not in view", async (page, server) => {
  const id = await server.run("plan", "twist-free-crowning");
  await page.addInitScript(
    () => (window.print = () => (window.missing = document.querySelectorAll('figure [role="status"]').length)),
  );
  await page.goto(`${server.address}/#/runs/${id}/motions`);
  await page.locator("main .chart svg").first().waitFor();
  assert.ok((await page.locator('figure [role="status"]').count()) > 0, "all charts are there at once");
  await button(page, "Print").click();
  await page.waitForFunction(() => window.missing !== undefined);
  assert.equal(await page.evaluate(() => window.missing), 0);
  const { charts } = await server.get(`runs/${id}`);
  assert.equal(await page.locator("main .chart svg").count(), charts.length);
});

site.test("every view has an address that can be gone back to", async (page, server) => {
  await openExample(page, server, "hob");
  for (const [key, view] of ["job", "runs", "inspect", "explore", "catalogue", "history", "compare"].entries()) {
    await page.keyboard.press(`Alt+Shift+Digit${key + 1}`);
    await page.waitForURL(`**/#/${view}`);
    await page.locator(`nav a[href="#/${view}"][aria-current="page"]`).waitFor();
  }
  await page.goBack();
  await tab(page, "Trend").waitFor();
  await page.goto(`${server.address}/#/nowhere`);
  await page.getByText("There is no such page.").waitFor();
});

site.test(
  "a part of the pages that is not there any more asks for the page to be loaded anew",
  async (page, server) => {
    await page.goto(server.address);
    await heading(page, "Start a job").waitFor();
    await page.route("**/assets/HistoryPage-*.js", (route) => route.fulfill({ status: 404, body: "" }));
    await page.keyboard.press("Alt+Shift+Digit6");
    await page.getByText("The server has other pages than this one by now.").waitFor();
    await page.unroute("**/assets/HistoryPage-*.js");
    await button(page, "Try again").click();
    await tab(page, "Trend").waitFor();
  },
  { allowed: [/status of 404/] },
);

site.test("a digit in a slider, a letter on a button: nothing leaves the view", async (page, server) => {
  await openExample(page, server, "twist-free-crowning");
  await button(page, "Plan").click();
  await page.getByText(/^planned in/).waitFor();
  await page.locator('main aside input[type="range"]').first().focus();
  for (const key of ["3", "p", "Alt+3", "Shift+Digit3"]) await page.keyboard.press(key);
  assert.match(page.url(), /#\/job\/plan$/);
});

site.test("a double click starts one run", async (page, server) => {
  await openExample(page, server, "twist-free-crowning");
  let started = 0;
  await page.route("**/api/runs", async (route) => {
    if (route.request().method() === "POST") {
      started++;
      await new Promise((resolve) => setTimeout(resolve, 400));
    }
    await route.continue();
  });
  await button(page, "Prove with the referee").dblclick();
  await page.waitForURL(/#\/runs\/\d+/);
  assert.equal(started, 1);
});
