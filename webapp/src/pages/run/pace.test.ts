import { expect, test } from "vitest";
import { nextPace, PACES } from "./pace";

test("each press goes one pace on, and no further than the ends", () => {
  expect(PACES.map((pace) => nextPace(pace, true))).toEqual([0.1, 0.25, 0.5, 0.75, 1, 1]);
  expect(PACES.map((pace) => nextPace(pace, false))).toEqual([0.05, 0.05, 0.1, 0.25, 0.5, 0.75]);
});

test("a speed between two paces goes to the nearest one in that direction", () => {
  expect(nextPace(0.3, true)).toBe(0.5);
  expect(nextPace(0.3, false)).toBe(0.25);
});
