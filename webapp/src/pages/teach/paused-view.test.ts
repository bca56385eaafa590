import { expect, test } from "vitest";
import { furthest } from "./paused-view";

test("the joint that is furthest off is named, and two degrees are near enough", () => {
  const from = [0, 10, 20, 0, -45, 0];
  expect(furthest(from, from.with(2, 18))).toEqual({ joint: 3, offDeg: 2, isHere: true });
  expect(furthest(from, from.with(4, -40).with(0, 1))).toEqual({
    joint: 5,
    offDeg: 5,
    isHere: false,
  });
  expect(furthest(from, from)?.isHere).toBe(true);
});

test("what is not known is not near", () => {
  expect(furthest([0], null)).toBeNull();
  expect(furthest(undefined, [0])).toBeNull();
});
