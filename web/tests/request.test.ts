// Addresses of requests.

import { describe, expect, it } from "vitest";
import { addressOf } from "../src/api/request";

describe("an address", () => {
  it("has everything in its place, and slashes in lists alone", () => {
    expect(addressOf("/api/about", {})).toBe("/api/about");
    expect(addressOf("/api/tools/{tool}", { tool: "a/b c" })).toBe("/api/tools/a%2Fb%20c");
    const file = { id: 7, name: ["programs", "työ.ngc"] };
    expect(addressOf("/api/runs/{id}/files/{name}", file)).toBe("/api/runs/7/files/programs/ty%C3%B6.ngc");
  });
  it("asks only for what is given", () => {
    expect(addressOf("/api/trends", {}, { series: "ring & pinion", flank: "", name: undefined })).toBe(
      "/api/trends?series=ring%20%26%20pinion",
    );
  });
});
