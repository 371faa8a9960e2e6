// Undo and redo across form and text.

import { describe, expect, it } from "vitest";
import { Undo } from "../src/lib/undo";

describe("Undo", () => {
  it("goes back and forth", () => {
    const undo = new Undo<string>();
    undo.keep("a", "form x", 0);
    undo.keep("b", "form y", 10);
    expect(undo.undo("c")).toBe("b");
    expect(undo.undo("b")).toBe("a");
    expect(undo.undo("a")).toBeUndefined();
    expect(undo.redo("a")).toBe("b");
    expect(undo.redo("b")).toBe("c");
    expect(undo.redo("c")).toBeUndefined();
  });
  it("takes quick changes of one origin as one step, slow ones as several", () => {
    const undo = new Undo<string>();
    undo.keep("", "text", 0);
    undo.keep("h", "text", 100);
    undo.keep("he", "text", 200);
    expect(undo.undo("hel")).toBe("");
    const slow = new Undo<string>();
    slow.keep("", "text", 0);
    slow.keep("h", "text", 5000);
    expect(slow.undo("he")).toBe("h");
  });
  it("forgets what was undone once something new is done, and the oldest when there is too much", () => {
    const undo = new Undo<number>({}, 3);
    for (let state = 0; state < 10; state++) undo.keep(state, `step ${state}`, state);
    expect(undo.past).toEqual([7, 8, 9]);
    undo.undo(10);
    undo.keep(9, "other", 100);
    expect(undo.redo(11)).toBeUndefined();
  });
  it("begins a new step after an undo", () => {
    const undo = new Undo<string>();
    undo.keep("a", "text", 0);
    undo.undo("b");
    undo.keep("a", "text", 10);
    expect(undo.undo("c")).toBe("a");
  });
});
