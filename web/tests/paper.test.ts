// Printing waits for what has not been in view.

import { afterEach, expect, it, vi } from "vitest";
import { loadForPaper, printPage } from "../src/lib/paper";

afterEach(() => vi.unstubAllGlobals());

it("prints when everything is there", async () => {
  const done: string[] = [];
  vi.stubGlobal("print", () => done.push("printed"));
  const load = (name: string) => async () => {
    await Promise.resolve();
    done.push(name);
  };
  const forget = [loadForPaper(load("first")), loadForPaper(load("second"))];
  forget[1]!();
  await printPage();
  await new Promise((resolve) => setTimeout(resolve));
  expect(done).toEqual(["first", "printed"]);
  forget[0]!();
});
