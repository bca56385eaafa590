import { describe, expect, it } from "vitest";
import { pickLanguage } from "./language";

const AVAILABLE = ["en", "de", "fr", "it"];

describe("the language", () => {
  it("is the one a person chose", () => {
    expect(pickLanguage("it", ["de-CH"], AVAILABLE)).toBe("it");
  });

  it("is the phone's first that there is, whatever the country", () => {
    expect(pickLanguage(null, ["pl-PL", "de-CH", "fr"], AVAILABLE)).toBe("de");
  });

  it("is the first of ours when the phone knows none of them", () => {
    expect(pickLanguage("xx", ["pl"], AVAILABLE)).toBe("en");
    expect(pickLanguage(null, [], AVAILABLE)).toBe("en");
  });
});
