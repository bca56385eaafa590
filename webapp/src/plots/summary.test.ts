import { expect, test } from "vitest";
import { paddedRange, sentence, summarise } from "./summary";

test("a curve's start, end and extremes", () => {
  expect(summarise([1, 5, -2, 3])).toEqual({ start: 1, end: 3, lowest: -2, highest: 5 });
  expect(summarise([])).toBeNull();
});

test("the sentence names the joint that moves most", () => {
  const text = sentence(
    "Take",
    [1, 3.5],
    [
      [0, 0],
      [0, 10],
      [5, 4],
      [0, 0],
      [0, 0],
      [0, 0],
    ],
  );
  expect(text).toBe("Take: 2.5 s. Joint 2 moves most, 10.0°.");
});

test("an empty recording has a sentence too", () => {
  expect(sentence("Take", [], [])).toContain("Nothing recorded");
});

test("a joint that stands still is not blown up", () => {
  expect(paddedRange(10, 10.02)).toEqual([8.01, 12.01]);
  expect(paddedRange(0, 100)).toEqual([-5, 105].map((value) => expect.closeTo(value)));
});
