// Pages of a browser for tests: each test gets a fresh one, and fails on whatever the console or the content security policy complains
// about and on every request to another host. Pictures are left in the folder PICTURES, if it is given.

import assert from "node:assert/strict";
import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { chromium } from "playwright-core";
import { Server } from "./server.mjs";

export const PICTURES = process.env.PICTURES;
/** Waiting for what a page or a request does, and for what a run of the referee takes in a debug build on a slow machine. */
const WAIT_MS = 20_000;
export const RUN_MS = 60_000;
const SIZE = { width: 1280, height: 800 };

/** A server and a browser for the tests of one file. `options` and `environment` are those of the server, `prepare` fills its store. */
export function useSite({ options, environment, prepare } = {}) {
  const site = { server: undefined, browser: undefined };
  before(async () => {
    site.server = await Server.start(options, environment);
    await prepare?.(site.server);
    site.browser = await chromium.launch({
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      // As Chromium does by itself where there is no graphics hardware.
      args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
    });
  });
  after(async () => {
    await site.browser?.close();
    await site.server?.stop();
  });
  /** A test with a page of its own; `allowed` are complaints of the console that it provokes. */
  site.test = (name, work, { allowed = [], ...context } = {}) =>
    test(name, async () => {
      const pages = await site.browser.newContext({ viewport: SIZE, locale: "en", ...context });
      pages.setDefaultTimeout(WAIT_MS);
      const complaints = watch(pages, site.server);
      const page = await pages.newPage();
      try {
        await work(page, site.server);
        const others = complaints.filter((complaint) => !allowed.some((pattern) => pattern.test(complaint)));
        assert.deepEqual(others, [], "the page complained");
      } catch (error) {
        await picture(page, `failed ${name}`);
        throw error;
      } finally {
        await pages.close();
      }
    });
  return site;
}

function watch(pages, server) {
  const complaints = [];
  pages.on("console", (message) => message.type() === "error" && complaints.push(`console: ${message.text()}`));
  pages.on("weberror", (error) => complaints.push(`error: ${error.error()}`));
  pages.on("request", (request) => {
    const to = new URL(request.url());
    if (!["data:", "blob:"].includes(to.protocol) && to.host !== `127.0.0.1:${server.port}`)
      complaints.push(`request to ${request.url()}`);
  });
  return complaints;
}

export async function picture(page, name) {
  if (!PICTURES) return;
  await mkdir(PICTURES, { recursive: true });
  await page.screenshot({ path: join(PICTURES, `${name.replaceAll("/", " ")}.png`) });
}

export const button = (page, name) => page.getByRole("button", { name, exact: true });
export const tab = (page, name) => page.getByRole("tab", { name });
export const heading = (page, name) => page.getByRole("heading", { name });
export const valid = (page) => page.locator('[data-state="valid"]').waitFor();

/** Opens an example from the start page, as a newcomer does. */
export async function openExample(page, server, name) {
  await page.goto(server.address);
  await page
    .getByRole("button", { name: new RegExp(`^${name}\\b`) })
    .first()
    .click();
  await page.getByRole("heading", { name, level: 1 }).waitFor();
  await valid(page);
}

/** Waits until a condition in Node.js holds, where there is nothing in the page to wait for. */
export async function until(condition, what) {
  const end = performance.now() + WAIT_MS;
  while (!(await condition())) {
    if (performance.now() > end) throw new Error(`in vain: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

/** Drops files as a hand does: `files` are `{ name, text }`. */
export async function drop(page, target, files) {
  const data = await page.evaluateHandle((files) => {
    const data = new DataTransfer();
    for (const { name, text } of files) data.items.add(new File([text], name));
    return data;
  }, files);
  await page.locator(target).dispatchEvent("dragover", { dataTransfer: data });
  await page.locator(target).dispatchEvent("drop", { dataTransfer: data });
}

/** Times of a user are judged by what is promised only on a machine of its own; shared machines are slow at times of their own. */
export function limitMs(variable, promised) {
  return Number(process.env[variable] ?? (process.env.STRICT_TIMES === "1" ? promised : Math.max(1000, 4 * promised)));
}

/** What goes over the right edge of the page, none if nothing does. */
export function widerThanPage(page) {
  return page.evaluate(() => {
    const scrolls = [document.documentElement, ...document.querySelectorAll("main, .page, dialog .body")];
    return scrolls.filter((some) => some.scrollWidth > some.clientWidth + 1).map((some) => `${some.tagName}.${some.className}`);
  });
}

/** What a finger is to press and is less than 44 px high; a box counts with its label. */
export function smallTargets(page) {
  return page.evaluate(() => {
    const boxes = 'input[type="checkbox"], input[type="radio"]';
    const targets = [...document.querySelectorAll('button, a[href]:not(.skip), select, summary, input:not([type="file"])')];
    const pressed = targets.map((some) => (some.matches(boxes) ? (some.closest("label") ?? some) : some));
    return pressed
      .map((some) => ({ some, box: some.getBoundingClientRect() }))
      .filter(({ some, box }) => box.width > 0 && box.height < 43.5 && !some.closest(".visually-hidden"))
      .map(({ some, box }) => `${some.tagName} ${some.innerText ?? ""} ${box.height}`);
  });
}

/** Waits for the verdict in the head of a run: met, missed or not_judged. */
export const verdict = (page, status, timeout = WAIT_MS) =>
  page.locator(`main header span.${status}`).first().waitFor({ timeout });
