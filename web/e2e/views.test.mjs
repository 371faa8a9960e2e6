// Every view at 1280 x 800 in light, dark and German: nothing goes over the edge, nothing fails. With PICTURES each leaves a picture.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { openExample, picture, smallTargets, useSite, widerThanPage } from "./page.mjs";
import { exampleText, inRepository } from "./server.mjs";

const LOOKS = [
  { name: "light", colorScheme: "light", locale: "en" },
  { name: "dark", colorScheme: "dark", locale: "en" },
  { name: "german", colorScheme: "light", locale: "de-DE" },
];
const TEXT = ".cm-line";
const FAILED = "main .failure";
let runs;

const site = useSite({ prepare });

async function prepare(server) {
  await server.command("store", "catalogue", "add", inRepository("examples/catalogue/bodies.toml"));
  await server.command("store", "history", "add", inRepository("examples/skiving/history.jsonl"));
  const curves = await readFile(inRepository("fuzz/seeds/klingelnberg/curves.mka"), "latin1");
  for (const part of ["4711", "4712", "4713"])
    await server.inspect(`${part}.mka`, curves.replaceAll("4711", part), { keep: true });
  const job = { text: await exampleText("inspection/measured.toml"), files: {} };
  runs = {
    plan: await server.run("plan", "twist-free-crowning"),
    other: await server.run("plan", "twist-free-crowning", (text) => text.replace("amount_um = 20.0", "amount_um = 18.0")),
    failed: await server.run("simulate", "hob"),
    study: await server.run("explore", "twist-free-crowning"),
    bodies: await server.run("explore", "catalogue"),
    inspection: await server.inspect("measured.csv", await exampleText("inspection/measured.csv"), {}, job),
    skiving: await server.run("plan", "skiving/worn-tool"),
    milling: await server.run("plan", "milling/blade-on-head-head"),
    gearbox: await server.run("plan", "gearbox/reference-train"),
  };
}

/** Views by their address, each with what stands there when it is complete. */
function views() {
  const { plan, other, failed, study, bodies, inspection, skiving, milling, gearbox } = runs;
  return [
    ["job", TEXT],
    ["job/plan", ".net .label"],
    ["runs", "tbody tr"],
    [`runs/${plan}`, ".body .bar"],
    [`runs/${plan}/flank`, "figure canvas"],
    [`runs/${plan}/motions`, ".chart svg"],
    [`runs/${plan}/process`, "canvas"],
    [`runs/${plan}/programs`, "pre"],
    [`runs/${plan}/report`, "iframe"],
    [`runs/${plan}/files`, "td a"],
    [`runs/${plan}/numbers`, "details"],
    [`runs/${failed}`, ".failed li"],
    [`runs/${study}`, "circle"],
    [`runs/${bodies}`, ".panel"],
    [`runs/${inspection}`, "tbody tr"],
    [`runs/${inspection}/inspection`, "iframe"],
    [`runs/${inspection}/systematic`, "caption"],
    [`runs/${skiving}`, ".page"],
    [`runs/${milling}`, ".page"],
    [`runs/${milling}/programs`, "pre, .empty"],
    [`runs/${gearbox}`, ".page"],
    ["runs/check", "option"],
    ["inspect", ".zone"],
    ["explore", "fieldset"],
    ["catalogue", "tbody tr"],
    ["history", "circle"],
    ["history/parts", "tbody tr"],
    ["history/tools", "tbody tr"],
    ["compare", ".empty"],
    [`compare/${plan}/${other}`, "figure canvas"],
  ];
}

async function open(page, server, address, complete) {
  await page.goto(`${server.address}/#/${address}`);
  const parts = complete.split(", ").map((part) => `main ${part}`);
  await page.locator(parts.join(", ")).first().waitFor({ state: "attached" });
}

site.test(
  "what fingers press is at least 44 px high",
  async (page, server) => {
    await page.goto(server.address);
    await page.locator("main ul button").first().waitFor();
    assert.deepEqual(await smallTargets(page), [], "on the start page");
    await openExample(page, server, "twist-free-crowning");
    for (const [address, complete] of views()) {
      await open(page, server, address, complete);
      assert.deepEqual(await smallTargets(page), [], address);
    }
  },
  { hasTouch: true, isMobile: true },
);

for (const { name, ...look } of LOOKS) {
  site.test(
    `nothing goes over the edge: ${name}`,
    async (page, server) => {
      await page.goto(server.address);
      await page.locator("main ul button").first().waitFor();
      assert.deepEqual(await widerThanPage(page), [], "the start page is too wide");
      await picture(page, `${name} start`);
      await openExample(page, server, "twist-free-crowning");
      for (const [address, complete] of views()) {
        await open(page, server, address, complete);
        assert.equal(await page.locator(FAILED).count(), 0, `${address} shows a failure`);
        assert.deepEqual(await widerThanPage(page), [], `${address} is too wide`);
        await picture(page, `${name} ${address}`);
      }
      await page.goto(`${server.address}/#/job`);
      await page.locator(`main ${TEXT}`).first().waitFor();
      for (const tab of await page.locator('.index [role="tab"]').all()) {
        await tab.click();
        assert.deepEqual(await widerThanPage(page), [], `the form ${await tab.innerText()} is too wide`);
        await picture(page, `${name} form ${await tab.innerText()}`);
      }
      await page.locator("main h1").click();
      await page.keyboard.press("?");
      await page.getByRole("dialog").waitFor();
      await picture(page, `${name} help`);
    },
    look,
  );
}
