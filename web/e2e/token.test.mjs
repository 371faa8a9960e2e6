// A server that others can reach: without its token it says what to do, with it everything works, and the token leaves the address.

import assert from "node:assert/strict";
import { heading, openExample, useSite } from "./page.mjs";

const TOKEN = "browser-test-0123456789";
const site = useSite({ options: ["--host", "0.0.0.0"], environment: { FLANKWRIGHT_TOKEN: TOKEN } });
const local = (server) => `http://127.0.0.1:${server.port}`;
const REFUSED = { allowed: [/status of 401/, /Refused to apply style/] };

site.test(
  "without a token, or with a wrong one, it says what to do",
  async (page, server) => {
    for (const address of [local(server), `${local(server)}/?token=browser-test-9876543210`]) {
      const answer = await page.goto(address);
      assert.equal(answer.status(), 401);
      await page.getByText("this server asks for its token: open the address that it printed").waitFor();
    }
  },
  REFUSED,
);

site.test("with its token it works, and the token does not stay in the address", async (page, server) => {
  await page.goto(`${local(server)}/?token=${TOKEN}`);
  await heading(page, "Start a job").waitFor();
  assert.equal(page.url(), `${local(server)}/`);
  assert.equal(await page.evaluate(() => document.cookie), "", "scripts can read the token");
  await openExample(page, { address: local(server) }, "hob");
});

site.test(
  "a page whose token is no longer good says so",
  async (page, server) => {
    await page.goto(`${local(server)}/?token=${TOKEN}`);
    await heading(page, "Start a job").waitFor();
    await page.context().clearCookies();
    await page.keyboard.press("Alt+Shift+Digit2");
    await page.getByText("This server asks for a token.").waitFor();
    await page.getByText("Open the address with its token").waitFor();
  },
  REFUSED,
);
