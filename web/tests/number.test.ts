// Number formats: what a person reads and what is read from a person.

import { describe, expect, it } from "vitest";
import { formatBytes, formatFixed, formatNumber, formatSeconds, NO_VALUE, parseNumber, stepNumber } from "../src/lib/number";

describe("formatNumber", () => {
  it("keeps the digits that matter and adds the unit behind a narrow space", () => {
    expect(formatNumber(136.2157550763184, "en", 6, "mm")).toBe("136.216\u202fmm");
    expect(formatNumber(136.2157550763184, "de", 6, "mm")).toBe("136,216\u202fmm");
    expect(formatNumber(17.5, "en", 4, "°")).toBe("17.5°");
  });
  it("shows no minus before zero, and powers of ten where digits would be lost", () => {
    expect(formatNumber(-0, "en")).toBe("0");
    expect(formatNumber(3.1234e-5, "en", 4, "µm")).toBe("3.12e-5\u202fµm");
    expect(formatNumber(2.5e9, "de", 4)).toBe("2,5e9");
  });
  it("says that there is no value", () => {
    for (const none of [undefined, null, NaN, Infinity]) expect(formatNumber(none, "en")).toBe(NO_VALUE);
  });
});

describe("formatFixed", () => {
  it("aligns decimals", () => {
    expect(formatFixed(5, "en", 2)).toBe("5.00");
    expect(formatFixed(5, "en", 2, "mm")).toBe("5.00\u202fmm");
    expect(formatFixed(5, "en", 2, "°")).toBe("5.00°");
    expect(formatFixed(-0.0004, "en", 2)).toBe("0.00");
    expect(formatFixed(12345.678, "de", 1)).toBe("12.345,7");
  });
});

describe("parseNumber", () => {
  it("takes point and comma, signs, exponents and spaces", () => {
    expect(parseNumber("-35,5")).toBe(-35.5);
    expect(parseNumber(" +1.5e-3 ")).toBe(0.0015);
    expect(parseNumber("−2")).toBe(-2);
    expect(parseNumber("1 000")).toBe(1000);
  });
  it("refuses what is no number", () => {
    for (const text of ["", "-", "1.2.3", "1,2,3", "abc", "0x10", "1e999"]) expect(parseNumber(text)).toBeUndefined();
  });
});

describe("stepNumber", () => {
  it("steps the last digit that is written", () => {
    expect(stepNumber("88.5315", 1)).toBe("88.5316");
    expect(stepNumber("17.5", -1)).toBe("17.4");
    expect(stepNumber("19", 10)).toBe("29");
    expect(stepNumber("text", 1)).toBe("text");
  });
});

describe("sizes and times", () => {
  it("choose their unit", () => {
    expect(formatBytes(812, "en")).toBe("812\u202fB");
    expect(formatBytes(346531, "en")).toBe("347\u202fkB");
    expect(formatSeconds(0.0573, "en")).toBe("57.3\u202fms");
    expect(formatSeconds(125, "en")).toBe("2:05\u202fmin");
    expect(formatSeconds(119.7, "en")).toBe("2:00\u202fmin");
    expect(formatSeconds(7500, "en")).toBe("2:05\u202fh");
  });
});
