import { expect, test } from "vitest";
import { day, moment, month } from "./when";

test("a moment has the day and the time of day", () => {
  const text = moment(new Date(2026, 10, 24, 19, 5).toISOString());
  expect(text).toContain("24");
  expect(text).toContain("Nov");
  expect(text).toContain("19:05");
});

test("a calendar day stays the same day in every time zone", () => {
  expect(day("2026-11-01")).toBe("Nov 1");
  expect(month("2026-11-01")).toBe("November 2026");
});
