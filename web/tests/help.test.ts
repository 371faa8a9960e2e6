// Help in the language chosen.

import { beforeEach, describe, expect, it } from "vitest";
import { HelpOfEntries } from "../src/texts/help.svelte";
import { i18n } from "../src/texts/i18n.svelte";

const TEETH = { key: "BevelGear.teeth", english: "Number of teeth." };

describe("help", () => {
  beforeEach(() => {
    i18n.lang = "de";
  });

  it("is German where German is chosen", async () => {
    const help = new HelpOfEntries();
    await help.load();
    expect(help.of(TEETH)).toBe("Zähnezahl.");
    i18n.lang = "en";
    expect(help.of(TEETH)).toBe(TEETH.english);
  });

  it("is English until German is there, and where German lacks it", async () => {
    const help = new HelpOfEntries();
    expect(help.of(TEETH)).toBe(TEETH.english);
    await help.load();
    expect(help.of({ key: "Gear.none", english: "What no schema says." })).toBe("What no schema says.");
    expect(help.of(undefined)).toBe("");
  });

  it("is not loaded where English is chosen, and asked for again where loading fails", async () => {
    const help = new HelpOfEntries();
    let asked = 0;
    const load = async () => {
      if (++asked === 1) throw new Error("gone");
      return { default: { [TEETH.key]: "Zähnezahl." } };
    };
    i18n.lang = "en";
    await help.load(load);
    expect(asked).toBe(0);
    i18n.lang = "de";
    await help.load(load);
    expect(help.of(TEETH)).toBe(TEETH.english);
    await help.load(load);
    await help.load(load);
    expect(help.of(TEETH)).toBe("Zähnezahl.");
    expect(asked).toBe(2);
  });
});
