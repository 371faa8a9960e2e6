// The first page of a report, as it is printed: one sheet of A4 for an example of each process, in both languages where texts grow longest.

import assert from "node:assert/strict";
import { useSite } from "./page.mjs";
import { exampleText } from "./server.mjs";

const site = useSite();

/** Pixels of a millimetre, in CSS. */
const MM = 96 / 25.4;
/** Width and height of the sheet, mm. */
const A4 = [210, 297];

/** The job with a report in German. */
const inGerman = (text) => {
  const language = 'language = "de"';
  return text.includes("[output]\n") ? text.replace("[output]\n", `[output]\n${language}\n`) : `${text}\n[output]\n${language}\n`;
};

const inEnglish = (text) => text;

/** The report of a run as it stands in its files. */
async function report(server, id) {
  return (await server.bytes(`runs/${id}/files/report.html`)).toString("utf8");
}

/** Room on the printed sheet by the margins of the report's own style, mm: its width and height. */
function room(page) {
  return page.evaluate(([width, height]) => {
    const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]);
    const sheet = rules.find((rule) => rule instanceof CSSPageRule && /size/i.test(rule.cssText));
    const margin = (side) => {
      const length = sheet.style.getPropertyValue(`margin-${side}`);
      if (!length.endsWith("mm")) throw new Error(`margin of the sheet: ${length}`);
      return parseFloat(length);
    };
    return [width - margin("left") - margin("right"), height - margin("top") - margin("bottom")];
  }, A4);
}

/** Sheets of paper that the first page takes by itself. */
async function sheets(page) {
  await page.addStyleTag({
    content: "main > :not(.first) { display: none !important; } .first { break-after: auto !important; }",
  });
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
  return pdf.match(/\/Type\s*\/Page\b/g).length;
}

/** Opens the report at the width of the sheet and holds its first page to the height of it. */
async function fits(page, name, html) {
  await page.emulateMedia({ media: "print" });
  await page.setContent(html);
  const [width, height] = await room(page);
  assert.ok(width > 150 && height > 230, `${name}: the sheet has room for ${width} by ${height} mm`);
  await page.setViewportSize({ width: Math.round(width * MM), height: Math.round(height * MM) });
  const first = page.locator(".first.sheet");
  assert.equal(await first.count(), 1, `${name}: no first page with a sheet of its own`);
  const box = await first.boundingBox();
  const used = box.height / MM;
  assert.ok(used <= height, `${name}: the first page is ${used.toFixed(1)} mm high, the sheet has ${height} mm`);
  const over = await first.evaluate((sheet) => sheet.scrollWidth - sheet.clientWidth);
  assert.ok(over <= 1, `${name}: the first page is ${over} px too wide`);
  assert.equal(await sheets(page), 1, `${name}: printed sheets of the first page`);
  return used;
}

const PLANS = [
  ["cycles/planet-gear", [inEnglish, inGerman]],
  ["cycles/ev-gear", [inEnglish, inGerman]],
  ["two-end-reliefs", [inEnglish, inGerman]],
  ["tangential/example-1-small", [inEnglish, inGerman]],
  ["milling/spur-on-ac-table", [inEnglish, inGerman]],
  ["skiving/measured-ring", [inEnglish, inGerman]],
  ["gearbox/cheapest-set-up", [inEnglish, inGerman]],
];

for (const [example, languages] of PLANS) {
  site.test(`the first page of ${example} is one printed sheet`, async (page, server) => {
    for (const language of languages) {
      const html = await report(server, await server.run("plan", example, language));
      assert.match(html, language === inGerman ? /<html lang="de">/ : /<html lang="en">/);
      await fits(page, `${example} ${language.name}`, html);
    }
  });
}

site.test("the first page of a measured gear is one printed sheet", async (page, server) => {
  const [measured, text] = await Promise.all(["measured.csv", "measured.toml"].map((name) => exampleText(`inspection/${name}`)));
  for (const language of [inEnglish, inGerman]) {
    const job = { text: language(text), files: {} };
    const html = await report(server, await server.inspect("measured.csv", measured, {}, job));
    await fits(page, `a measured gear ${language.name}`, html);
  }
});

site.test("a first page that is too long is found", async (page, server) => {
  const html = await report(server, await server.run("plan", "gearbox/cheapest-set-up"));
  const long = html.replace('<dl class="title-block">', `${"<p>one line more</p>".repeat(80)}<dl class="title-block">`);
  await assert.rejects(fits(page, "a long page", long), /mm high, the sheet has/);
});
