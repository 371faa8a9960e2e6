// Editing a job: findings at their fields and lines, one history for form and text, files, and a draft that outlives a reload.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { button, drop, heading, openExample, tab, useSite, valid, verdict } from "./page.mjs";
import { exampleText } from "./server.mjs";

const site = useSite();
const WIDTH = "#field-gear-face_width";
const text = (page) => page.evaluate(() => document.querySelector(".cm-content").innerText);
const textHas = (page, words) =>
  page.waitForFunction((words) => document.querySelector(".cm-content")?.innerText.includes(words), words);
const widthIs = (page, value) =>
  page.waitForFunction(([field, value]) => document.querySelector(field)?.value === value, [WIDTH, value]);

async function openGear(page, server) {
  await openExample(page, server, "twist-free-crowning");
  await tab(page, "Gear").click();
  await textHas(page, "face_width");
}

site.test("a bad value is told at its field, in its line and with a way out", async (page, server) => {
  await openGear(page, server);
  await page.locator(WIDTH).fill("-3");
  const finding = page.locator(".field.found .finding");
  await finding.waitFor();
  assert.match(await finding.innerText(), /is outside its range.*Allowed: .*\n.*give the face width/);
  assert.equal(await page.locator(".field.found label").innerText(), "Face width");
  await page.locator(".cm-lintRange-error").waitFor();
  assert.equal(await page.locator(".cm-lintRange-error").innerText(), "-3");
  assert.equal(await page.locator('[role="status"][data-state="invalid"]').innerText(), "1 finding");
  assert.ok(await button(page, "Prove with the referee").isDisabled(), "a bad job could be run");

  // In the list below it says the same with its line, and leads there.
  const listed = page.locator("ul button", { hasText: "is outside its range" });
  assert.match(await listed.innerText(), /line 15[\s\S]*Remedy\s+give the face width in mm/);
  await tab(page, "Worm").click();
  await listed.click();
  await page.locator(WIDTH).waitFor();
  assert.equal(await page.evaluate(() => getSelection()?.toString()), "-3");

  await page.locator(WIDTH).fill("41");
  await valid(page);
  assert.equal(await page.locator(".field.found, .cm-lintRange-error").count(), 0);
});

site.test("a text that is no TOML says where, and the form waits", async (page, server) => {
  await openGear(page, server);
  await page.locator(".cm-line", { hasText: "face_width" }).click();
  await page.keyboard.press("End");
  await page.keyboard.type(" = 3");
  await page.getByText("The text cannot be read as it stands").waitFor();
  assert.match(await page.locator("ul button", { hasText: "this is not TOML" }).innerText(), /line 15/);
  assert.ok(await page.locator(WIDTH).isDisabled(), "the form edits a text that cannot be read");
  await page.locator(".cm-lint-marker-error").waitFor();
  await page.keyboard.press("Control+z");
  await valid(page);
});

site.test("undo and redo go through form and text alike", async (page, server) => {
  await openGear(page, server);
  const before = await text(page);
  await page.locator(WIDTH).fill("42");
  await textHas(page, "face_width = 42");
  assert.ok((await text(page)).includes("# left-hand"), "an edit of the form lost a comment");

  await page.locator(".cm-line", { hasText: "teeth = 19" }).click();
  await page.keyboard.press("End");
  await page.keyboard.press("Backspace");
  await page.keyboard.type("7");
  await page.waitForFunction(() => document.querySelector("#field-gear-teeth").value === "17");

  // Back through what was typed, then through what the form wrote.
  for (let step = 0; (await text(page)) !== before; step++) {
    assert.ok(step < 6, `undo did not bring the job back: ${await page.locator(WIDTH).inputValue()}`);
    const shown = await text(page);
    await button(page, "Undo").click();
    await page.waitForFunction((shown) => document.querySelector(".cm-content").innerText !== shown, shown);
  }
  await widthIs(page, "40");
  await page.waitForFunction(() => document.querySelector("#field-gear-teeth").value === "19");
  await page.locator("h1").click();
  await page.keyboard.press("Control+y");
  await textHas(page, "face_width = 42");
  await widthIs(page, "42");
  await page.keyboard.press("Control+z");
  await widthIs(page, "40");
  await valid(page);
});

site.test("a job is saved as a file and opened again", async (page, server) => {
  await openGear(page, server);
  await page.locator(WIDTH).fill("41");
  await textHas(page, "face_width = 41");
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+s")]);
  assert.equal(download.suggestedFilename(), "twist-free-crowning.toml");
  const saved = await readFile(await download.path(), "utf8");
  const { text: example } = await server.get("examples/twist-free-crowning");
  assert.equal(saved, example.replace("face_width = 40.0", "face_width = 41"));

  await button(page, "New").click();
  await page.getByRole("dialog").getByRole("button", { name: "Electronic gearbox" }).click();
  await textHas(page, "electronic-gearbox");
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), button(page, "Open").click()]);
  await chooser.setFiles({ name: "mine.toml", mimeType: "text/plain", buffer: Buffer.from(saved) });
  await heading(page, "twist-free-crowning").waitFor();
  await tab(page, "Gear").click();
  await widthIs(page, "41");
});

site.test("a job is dropped with the tables that it names", async (page, server) => {
  await page.goto(server.address);
  await heading(page, "Start a job").waitFor();
  await drop(page, ".job", [
    { name: "variable-ratio.csv", text: await exampleText("variable-ratio.csv") },
    { name: "variable-ratio.toml", text: await exampleText("variable-ratio.toml") },
  ]);
  await heading(page, "variable-ratio").waitFor();
  await valid(page);
  await tab(page, "Files of the job").click();
  await page.getByText("variable-ratio.csv", { exact: true }).waitFor();
  await page.getByRole("button", { name: "Remove variable-ratio.csv" }).click();
  await page.getByText("The job names variable-ratio.csv, which is not with it yet.").waitFor();
});

site.test("the draft outlives a reload with its history", async (page, server) => {
  await openGear(page, server);
  await page.locator(WIDTH).fill("43");
  await textHas(page, "face_width = 43");
  await page.reload();
  await heading(page, "twist-free-crowning").waitFor();
  await textHas(page, "face_width = 43");
  await button(page, "Undo").click();
  await textHas(page, "face_width = 40.0");
});

site.test("from the start to a plan and its proof without a mouse", async (page, server) => {
  await page.goto(server.address);
  await heading(page, "Start a job").waitFor();
  const focused = (selector) => page.waitForFunction((selector) => document.activeElement?.matches(selector), selector);
  await page.keyboard.press("Tab");
  await focused("a.skip");
  await page.keyboard.press("Enter");
  await focused("main");
  // On to the search of examples.
  for (let step = 0; !(await page.evaluate(() => document.activeElement.matches('[type="search"]'))); step++) {
    assert.ok(step < 20, "Tab does not reach the search");
    await page.keyboard.press("Tab");
  }
  await page.keyboard.type("twist-free");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await heading(page, "twist-free-crowning").waitFor();
  await valid(page);
  await page.keyboard.press("Alt+Shift+KeyP");
  await page.getByText(/^planned in/).waitFor();
  await page.keyboard.press("Control+Enter");
  await page.getByRole("tab", { name: "Summary" }).waitFor();
  await verdict(page, "met");

  // The tabs of the run by arrows, the views by digits with Alt and Shift, the overview by its key.
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Keyboard shortcuts" }).waitFor();
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  await page.getByRole("tab", { name: "Summary" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Flank");
  await page.keyboard.press("Alt+Shift+Digit2");
  await heading(page, "Runs").waitFor();
});

site.test("what is wrong in a field is said to those who do not see it, and wrong text stays", async (page, server) => {
  await openGear(page, server);
  const width = page.locator(WIDTH);
  await width.fill("88,6mm");
  await width.blur();
  assert.equal(await width.inputValue(), "88,6mm");
  assert.equal(await width.getAttribute("aria-invalid"), "true");
  const complaint = (await width.getAttribute("aria-describedby")).split(" ")[0];
  assert.match(await page.locator(`#${complaint}`).innerText(), /not a number/);
  await width.fill("40");
  await valid(page);
  const tip = page.locator("#field-gear-tip_diameter");
  await tip.fill("70");
  await page.waitForFunction(() => document.querySelector("#field-gear-tip_diameter").getAttribute("aria-invalid") === "true");
  const said = (await tip.getAttribute("aria-describedby")).split(" ").find((id) => id.endsWith("-findings"));
  assert.ok((await page.locator(`#${said}`).innerText()).length > 10);
});
