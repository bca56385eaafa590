import { expect, test } from "vitest";
import { age, degrees, duration, errorDegrees, parseDecimal, percent } from "./numbers";

test("typed numbers may have a comma, a point, a sign and spaces", () => {
  expect(parseDecimal("12,5")).toBe(12.5);
  expect(parseDecimal(" -12.5 ")).toBe(-12.5);
  expect(parseDecimal("−3")).toBe(-3);
  expect(parseDecimal("+,5")).toBe(0.5);
  expect(parseDecimal("7.")).toBe(7);
});

test("what is not one number is refused", () => {
  for (const text of ["", " ", "-", "1,2,3", "1.000,5", "1e3", "NaN", "Infinity", "12°", "0x10"]) {
    expect(parseDecimal(text), text).toBeNull();
  }
});

test("durations and ages", () => {
  expect(duration(7.25)).toBe("7.3 s");
  expect(duration(59.96)).toBe("1:00 min");
  expect(duration(125)).toBe("2:05 min");
  expect(age(2900)).toBe("2 s");
  expect(age(61_500)).toBe("1:01 min");
});

test("signs and units", () => {
  expect(degrees(-12.34)).toBe("−12.3°");
  expect(degrees(-0.01)).toBe("0.0°");
  expect(percent(0.254)).toBe("25 %");
  expect(errorDegrees(0.0004, 3)).toBe("under 0.001°");
  expect(errorDegrees(0.0016, 3)).toBe("0.002°");
});
