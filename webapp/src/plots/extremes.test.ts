import { expect, test } from "vitest";
import { pointAt, timesWithExtremes, valuesWithExtremes } from "./extremes";

test("a spike between two points is drawn", () => {
  const times = timesWithExtremes([0, 1, 2]);
  const values = valuesWithExtremes([5, 5, 6], [5, 2, 6], [9, 6, 6]);
  expect(times).toEqual([0, 0.5, 1, 1.5, 2]);
  expect(values).toEqual([5, 9, 5, 2, 6]);
});

test("nothing recorded stays nothing, and one point stays one", () => {
  expect(timesWithExtremes([])).toEqual([]);
  expect(valuesWithExtremes([], [], [])).toEqual([]);
  expect(timesWithExtremes([3])).toEqual([3]);
  expect(valuesWithExtremes([7], [6], [8])).toEqual([7]);
});

test("the point of a time is the last one that has come", () => {
  const times = [0, 1, 2, 4];
  expect([-1, 0, 0.9, 1, 3.9, 4, 9].map((at) => pointAt(times, at))).toEqual([0, 0, 0, 1, 2, 3, 3]);
  expect(pointAt([], 1)).toBe(0);
});
