// One run for one wish.

import { afterEach, describe, expect, it, vi } from "vitest";
import { once } from "../src/lib/once";

vi.mock("../src/lib/router.svelte", () => ({ router: { go: vi.fn(), parts: [] } }));

describe("starting a run", () => {
  afterEach(() => vi.restoreAllMocks());
  it("asks for one run at a double click, and for another one later", async () => {
    const api = await import("../src/api/client");
    const { startRun } = await import("../src/job/start");
    vi.spyOn(api, "about").mockRejectedValue(new TypeError("no server"));
    const started = vi
      .spyOn(api, "startRun")
      .mockImplementation(() => new Promise((resolve) => setTimeout(() => resolve({ id: 7 }), 5)));
    await Promise.all([startRun("plan"), startRun("plan")]);
    expect(started).toHaveBeenCalledTimes(1);
    await startRun("plan");
    expect(started).toHaveBeenCalledTimes(2);
  });
  it("goes on side by side for different things", async () => {
    const work = vi.fn((_: string) => new Promise<void>((resolve) => setTimeout(resolve, 3)));
    const guarded = once(work, (name) => name);
    await Promise.all([guarded("a"), guarded("b"), guarded("a")]);
    expect(work.mock.calls).toEqual([["a"], ["b"]]);
  });
  it("can be tried again after a failure", async () => {
    const work = vi.fn().mockRejectedValueOnce(new Error("no")).mockResolvedValue(undefined);
    const guarded = once(work);
    await expect(guarded()).rejects.toThrow("no");
    await guarded();
    expect(work).toHaveBeenCalledTimes(2);
  });
});
