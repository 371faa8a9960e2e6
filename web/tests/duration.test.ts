// How long runs took, with and without fractions of seconds in their times.

import { describe, expect, it } from "vitest";
import { i18n } from "../src/texts/i18n.svelte";
import { tookText } from "../src/runs/duration";

const took = (created: string, ended?: string | null) => tookText({ created, ended }, "en");

describe("tookText", () => {
  it("knows no more than the times tell", () => {
    expect(took("2026-11-23T14:05:07Z", "2026-11-23T14:05:07Z")).toBe("<\u202f1\u202fs");
    expect(took("2026-11-23T14:05:07Z", "2026-11-23T14:05:11Z")).toBe("4\u202fs");
    expect(took("2026-11-23T14:05:07.123Z", "2026-11-23T14:05:07.165Z")).toBe("42\u202fms");
    expect(took("2026-11-23T14:05:07.123456Z", "2026-11-23T14:05:10.4Z")).toBe("3.28\u202fs");
    expect(took("2026-11-23T14:05:07.9Z", "2026-11-23T16:07:08Z")).toBe("2:02\u202fh");
  });
  it("says nothing of runs that go on, or whose times make no sense", () => {
    expect(took("2026-11-23T14:05:07Z")).toBeUndefined();
    expect(took("2026-11-23T14:05:07Z", null)).toBeUndefined();
    expect(took("2026-11-23T14:05:07Z", "2026-11-23T14:05:06Z")).toBeUndefined();
    expect(took("soon", "later")).toBeUndefined();
  });
});

describe("points in time", () => {
  it("are shown without seconds, whether they have fractions or not", () => {
    expect(i18n.time("2026-11-23T14:05:07.123Z")).toBe(i18n.time("2026-11-23T14:05:07Z"));
    expect(i18n.time("2026-11-23T14:05:07.123Z")).not.toMatch(/07|123/);
  });
});
