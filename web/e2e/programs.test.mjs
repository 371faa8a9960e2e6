// Programs: any program followed on a machine, and what is wrong with one that is none.

import assert from "node:assert/strict";
import { button, heading, useSite } from "./page.mjs";

const site = useSite();

async function choose(page, name, text) {
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), button(page, "Choose a program").click()]);
  await chooser.setFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
}

site.test("a program is followed on its machine", async (page, server) => {
  const id = await server.run("plan", "twist-free-crowning");
  const { files } = await server.get(`runs/${id}`);
  const { name } =
    files.find((file) => /^programs\/.*grind/.test(file.name)) ?? files.find((file) => /^programs\//.test(file.name));
  const text = (await server.bytes(`runs/${id}/files/${name}`)).toString();
  await page.goto(`${server.address}/#/runs`);
  await page.getByRole("link", { name: "Check a program" }).click();
  await heading(page, "Check a program").waitFor();
  assert.ok(await button(page, "Check").isDisabled());
  await choose(page, name.split("/").at(-1), text);
  await page.getByLabel("Machine").selectOption("machines/eight-axis.toml");
  await button(page, "Check").click();
  await heading(page, "Axis travel").waitFor();
  const axes = await page.locator("tbody tr td:first-child").allTextContents();
  assert.ok(
    ["X1", "Z1", "C2"].every((axis) => axes.includes(axis)),
    `axes ${axes}`,
  );
});

site.test("axes are shown with their least and largest position, and the ends of their travel", async (page, server) => {
  const id = await server.run("plan", "twist-free-crowning");
  const { document, files } = await server.get(`runs/${id}`);
  const { file, axes } = document.programs.programs.find(
    (program) => program.job === "grinding" && program.control === "siemens",
  );
  const x1 = axes.find((axis) => axis.axis === "X1");
  const shown = [x1.from, x1.to].map((value) => `${value.toFixed(3)}\u202fmm`);
  await page.goto(`${server.address}/#/runs/${id}/programs`);
  await page.getByRole("button", { name: "grinding – siemens" }).click();
  const caption = page.locator("figcaption", { hasText: "X1" });
  await caption.waitFor();
  for (const value of shown)
    assert.ok((await caption.innerText()).includes(value), `${await caption.innerText()} without ${value}`);

  assert.ok(files.some((some) => some.name === file));
  const text = (await server.bytes(`runs/${id}/files/${file}`)).toString();
  await page.goto(`${server.address}/#/runs/check`);
  await choose(page, file.split("/").at(-1), text);
  await page.getByLabel("Machine").selectOption("machines/eight-axis.toml");
  await button(page, "Check").click();
  const row = page.getByRole("row", { name: /^X1/ });
  await row.waitFor();
  assert.match(await row.innerText(), /-420\smm[\s\S]*-20\smm/);
});

site.test(
  "a text that is no program is refused with its line",
  async (page, server) => {
    await page.goto(`${server.address}/#/runs/check`);
    await choose(page, "wrong.mpf", "N10 G1 X1=\nN20 HELLO WORLD\n");
    await page.waitForFunction(() => document.querySelectorAll("main select option").length > 1);
    await button(page, "Check").click();
    await page.locator("main .failure").waitFor();
    assert.match(await page.locator("main .failure").innerText(), /line \d/);
  },
  { allowed: [/status of 4\d\d/] },
);
