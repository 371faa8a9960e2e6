// The process in 3D. Whether a run has a scene is told by its answer: with one the canvas draws something, without one there is no tab.
// A scene of two boxes, put into the answers of the server, shows the view whether or not the server makes scenes of this process.

import assert from "node:assert/strict";
import { button, tab, until, useSite } from "./page.mjs";

const site = useSite();

const box = (id, kind, size) => ({
  id,
  kind,
  positions: [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].flatMap((z) => [x * size, y * size, z * size]))),
  indices: [0, 1, 3, 0, 3, 2, 4, 7, 5, 4, 6, 7, 0, 5, 1, 0, 4, 5, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3],
});
/** A pose: the rotation row by row, then the place. */
const at = (x) => [1, 0, 0, 0, 1, 0, 0, 0, 1, x, 0, 0];
const frames = [0, 25, 50].map((x) => ({ at: x, poses: { worm: at(x + 30) }, contact: [[x + 30, 10, 10]] }));
const SCENE = {
  bodies: [box("gear", "gear", 30), box("worm", "worm", 20)],
  stages: [{ id: "grinding", title: "Grinding", coordinate: { label: "z", unit: "mm" }, frames }],
};

/** What the canvas shows: how many pixels have the colours of a body, and what tells one picture from another. */
async function look(page) {
  const png = await page.locator(".process canvas").screenshot();
  const painted = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, picture.width, picture.height);
    const ground = data.slice(0, 3).join();
    let painted = 0;
    for (let at = 0; at < data.length; at += 4) if (data.slice(at, at + 3).join() !== ground) painted++;
    return painted / (data.length / 4);
  }, png.toString("base64"));
  return { png: png.toString("base64"), painted };
}

/** Waits until the canvas shows what `is` asks for. */
async function seen(page, is, what) {
  let shown;
  await until(async () => is((shown = await look(page))), what);
  return shown;
}

site.test("the tab is there if, and only if, the run has a scene", async (page, server) => {
  const id = await server.run("plan", "twist-free-crowning");
  const { scene } = await server.get(`runs/${id}`);
  await page.goto(`${server.address}/#/runs/${id}`);
  await tab(page, "Files").waitFor();
  assert.equal(await tab(page, "Process").count(), scene ? 1 : 0);
  if (!scene) return;
  await tab(page, "Process").click();
  await seen(page, ({ painted }) => painted > 0.02, "a body is drawn");
});

site.test("bodies are drawn, moved, hidden and looked at from all sides", async (page, server) => {
  const id = await server.run("plan", "hob");
  await page.route(`**/api/runs/${id}`, async (route) => {
    const answer = await route.fetch();
    await route.fulfill({ response: answer, json: { ...(await answer.json()), scene: true } });
  });
  await page.route(`**/api/runs/${id}/scene`, (route) => route.fulfill({ json: SCENE }));
  await page.goto(`${server.address}/#/runs/${id}/process`);
  const start = await seen(page, ({ painted }) => painted > 0.02, "the bodies are drawn");
  const isOther = (than) => (now) => now.png !== than.png;

  await page.getByRole("slider", { name: "Position z" }).fill("1");
  await page.locator("output", { hasText: "50" }).waitFor();
  const moved = await seen(page, isOther(start), "the worm moves");
  await button(page, "Along z").click();
  const above = await seen(page, isOther(moved), "the view turns");
  await button(page, "Show Worm").click();
  const alone = await seen(page, ({ painted }) => painted < above.painted, "the worm is hidden");
  assert.ok(alone.painted > 0, "the gear is hidden as well");
  await button(page, "Show Worm").click();
  await button(page, "Isometric").click();

  // By keys: playing from the start, turning and zooming.
  await page.locator(".process canvas").focus();
  await page.keyboard.press("Space");
  await button(page, "Pause").waitFor();
  await button(page, "Pause").click();
  const paused = await look(page);
  await page.locator(".process canvas").focus();
  await page.keyboard.press("ArrowLeft");
  const turned = await seen(page, isOther(paused), "an arrow turns the view");
  await page.keyboard.press("c");
  await seen(page, ({ painted }) => painted > turned.painted, "C goes to the contact");
});
