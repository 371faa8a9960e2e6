// Keys that leave a view need modifiers, so that a digit in a slider or a letter on a button does nothing of the kind.

import { describe, expect, it } from "vitest";
import { altShiftKey } from "../src/lib/shortcuts";

const press = (code: string, held: string[] = []) => ({
  code,
  altKey: held.includes("alt"),
  shiftKey: held.includes("shift"),
  ctrlKey: held.includes("ctrl"),
  metaKey: false,
});

describe("keys of views", () => {
  it("are digits and letters with Alt and Shift, by their place on the keyboard", () => {
    expect(altShiftKey(press("Digit3", ["alt", "shift"]))).toBe("3");
    expect(altShiftKey(press("KeyP", ["alt", "shift"]))).toBe("P");
  });
  it("are nothing without both", () => {
    for (const held of [[], ["alt"], ["shift"], ["ctrl", "alt", "shift"]]) {
      expect(altShiftKey(press("Digit3", held)), held.join()).toBeUndefined();
    }
    expect(altShiftKey(press("Enter", ["alt", "shift"]))).toBeUndefined();
  });
});
