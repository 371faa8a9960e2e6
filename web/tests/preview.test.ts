// The immediate plan: how often it is asked.

import { afterEach, describe, expect, it, vi } from "vitest";
import * as api from "../src/api/client";
import { RequestFailure } from "../src/api/failure";
import type { Preview } from "../src/api/types";
import { previews } from "../src/plan/preview.svelte";

const pause = (ms = 5): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
const tree = (amount: number) => ({ target: { modifications: [{ kind: "helix_crowning", amount_um: amount }] } });
const files = {};
const refusal = new RequestFailure("refused", 422, [{ code: "worm-too-short", message: "the worm is too short" }]);

describe("a plan", () => {
  afterEach(() => {
    previews.forget();
    vi.restoreAllMocks();
  });
  it("that was refused is asked once until the job changes", async () => {
    const asked = vi.spyOn(api, "preview").mockRejectedValue(refusal);
    // The page asks whenever something changes, the answer among it.
    for (let turn = 0; turn < 20; turn++) {
      previews.ask(tree(2000), files, []);
      await pause(2);
    }
    expect(asked).toHaveBeenCalledTimes(1);
    expect(previews.failure).toBe(refusal);
    previews.ask(tree(1999), files, []);
    await pause();
    expect(asked).toHaveBeenCalledTimes(2);
    const others = { "table.csv": "w" };
    previews.ask(tree(1999), others, []);
    await pause();
    expect(asked).toHaveBeenCalledTimes(3);
    previews.ask(tree(1999), others, ["motions"]);
    await pause();
    expect(asked, "other charts of a refused job").toHaveBeenCalledTimes(3);
  });
  it("keeps the last answer beside the refusal, and forgets the refusal with the next answer", async () => {
    const answer = { milliseconds: 1 } as Preview;
    const asked = vi.spyOn(api, "preview").mockResolvedValue(answer);
    previews.ask(tree(10), files, []);
    await pause();
    asked.mockRejectedValue(refusal);
    previews.ask(tree(2000), files, []);
    await pause();
    expect([previews.value, previews.failure]).toEqual([answer, refusal]);
    asked.mockResolvedValue(answer);
    previews.ask(tree(10), files, []);
    await pause();
    expect([previews.value, previews.failure]).toEqual([answer, undefined]);
  });
  it("is asked again by hand", async () => {
    const asked = vi.spyOn(api, "preview").mockRejectedValue(new TypeError("no network"));
    previews.ask(tree(1), files, ["motions"]);
    await pause();
    previews.retry();
    await pause();
    expect(asked.mock.calls.map(([job, charts]) => [job.text, charts])).toEqual(
      Array.from({ length: 2 }, () => [JSON.stringify(tree(1)), ["motions"]]),
    );
  });
});
