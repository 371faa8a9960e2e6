// Only the newest question counts.

import { describe, expect, it, vi } from "vitest";
import { Latest } from "../src/lib/latest";

const pause = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));

describe("Latest", () => {
  it("answers the first and the last of a burst, and nothing between", async () => {
    const done: number[] = [];
    const asked: number[] = [];
    const latest = new Latest<number, number>({
      run: async (input) => {
        asked.push(input);
        await pause(5);
        return input;
      },
      done: (output) => done.push(output),
      failed: () => undefined,
    });
    for (let input = 1; input <= 5; input++) latest.ask(input);
    await pause(30);
    expect(asked).toEqual([1, 5]);
    expect(done).toEqual([1, 5]);
    expect(latest.isBusy).toBe(false);
  });
  it("cancels a question that has missed its time once a newer one waits", async () => {
    const done = vi.fn();
    const failed = vi.fn();
    const latest = new Latest<number, number>({
      run: async (input, signal) => {
        if (input === 1) {
          await new Promise((_, reject) => signal.addEventListener("abort", () => reject(new DOMException("", "AbortError"))));
        }
        return input;
      },
      done,
      failed,
      budgetMs: 10,
    });
    latest.ask(1);
    latest.ask(2);
    await pause(40);
    expect(done).toHaveBeenCalledExactlyOnceWith(2, 2);
    expect(failed).not.toHaveBeenCalled();
  });
  it("tells failures and goes on", async () => {
    const failed = vi.fn();
    const latest = new Latest<number, number>({ run: () => Promise.reject(new Error("no")), done: () => undefined, failed });
    latest.ask(1);
    await pause(5);
    latest.ask(2);
    await pause(5);
    expect(failed).toHaveBeenCalledTimes(2);
  });
});
