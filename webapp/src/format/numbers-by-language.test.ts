import { afterEach, beforeEach, expect, test, vi } from "vitest";

/** The module as a phone of these languages has it. */
async function numbersOf(...languages: string[]) {
  vi.spyOn(navigator, "languages", "get").mockReturnValue(languages);
  return import("./numbers");
}

beforeEach(() => vi.resetModules());
afterEach(() => vi.restoreAllMocks());

test("German has a decimal comma, and its units keep to their numbers", async () => {
  const numbers = await numbersOf("de-DE", "en");
  expect(numbers.degrees(-12.34)).toBe("−12,3°");
  expect(numbers.duration(7.25)).toBe("7,3\u00a0s");
  expect(numbers.percent(0.25)).toBe("25\u00a0%");
  expect(numbers.errorDegrees(0.0004, 3)).toBe("unter 0,001°");
  expect(numbers.fixed(1234.5, 1)).toBe("1234,5");
});

test("the country of the phone decides where people of one language differ", async () => {
  const numbers = await numbersOf("de-CH");
  expect(numbers.degrees(12.34)).toBe("12.3°");
  expect(numbers.duration(7.25)).toBe("7.3\u00a0s");
});

test("French has a narrow space before the percent sign", async () => {
  const numbers = await numbersOf("fr-FR");
  expect(numbers.percent(0.25)).toBe("25\u202f%");
  expect(numbers.millimetres(1.24)).toBe("1,2\u00a0mm");
  expect(numbers.significant(0.012345, 4)).toBe("0,01235");
});

test("Italian has the percent sign right after the number", async () => {
  const numbers = await numbersOf("it-IT");
  expect(numbers.percent(0.254)).toBe("25%");
  expect(numbers.atMost(2.345, 2)).toBe("2,35");
  expect(numbers.atMost(2, 2)).toBe("2");
});

test("what is typed in either form is the same number, whatever the language", async () => {
  for (const language of ["en", "de-DE", "de-CH", "fr-CH", "it"]) {
    vi.resetModules();
    const numbers = await numbersOf(language);
    expect(numbers.parseDecimal("12,5")).toBe(12.5);
    expect(numbers.parseDecimal("12.5")).toBe(12.5);
    expect(numbers.parseDecimal(numbers.fixed(-0.25, 2))).toBe(-0.25);
  }
});

test("axis labels follow too", async () => {
  await numbersOf("fr");
  const { axisLabels } = await import("../plots/axis-numbers");
  expect(axisLabels([-0.5, 0], 0.5)).toEqual(["−0,5", "0,0"]);
});
