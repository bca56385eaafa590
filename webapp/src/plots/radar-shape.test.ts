import { expect, test } from "vitest";
import { extremes, onAxis, outline } from "./radar-shape";

const CENTRE = { x: 100, y: 80 };

/** The corners of an outline, read back from its path. */
const corners = (path: string) =>
  path
    .slice(1, -1)
    .split("L")
    .map((corner) => corner.split(" ").map(Number) as [number, number]);

test("the first axis points up and the others follow clockwise", () => {
  expect(onAxis(0, 5, 1, CENTRE, 50)).toEqual({ x: 100, y: 30 });
  // A regular pentagon's corners: sin 72° = 0.9511, cos 72° = 0.3090, sin 144° = 0.5878.
  const right = onAxis(1, 5, 1, CENTRE, 100);
  expect(right.x).toBeCloseTo(195.11, 2);
  expect(right.y).toBeCloseTo(49.1, 2);
  const below = onAxis(2, 5, 1, CENTRE, 100);
  expect(below.x).toBeCloseTo(158.78, 2);
  expect(below.y).toBeCloseTo(160.9, 2);
  const left = onAxis(4, 5, 1, CENTRE, 100);
  expect(left.x).toBeCloseTo(2 * CENTRE.x - right.x, 9);
  expect(left.y).toBeCloseTo(right.y, 9);
});

test("an outline is as far out on each axis as its value says", () => {
  const values = [5, 4, 3, 2, 1];
  const distances = corners(outline(values, CENTRE, 50)).map(([x, y]) =>
    Math.hypot(x - CENTRE.x, y - CENTRE.y),
  );
  expect(distances).toHaveLength(5);
  values.forEach((value, axis) => expect(distances[axis]).toBeCloseTo(10 * value, 0));
});

test("a value out of the scale stays inside the drawing", () => {
  const [top, , , , left] = corners(outline([9, 1, 1, 1, -3], CENTRE, 50));
  expect(top).toEqual([100, 30]);
  expect(left).toEqual([100, 80]);
  expect(outline([], CENTRE, 50)).toBe("");
});

test("the best and the weakest axis are named, unless they read the same", () => {
  expect(extremes([4, 4.6, 3.2, 4.6, 4])).toEqual({ best: 1, worst: 2, even: false });
  expect(extremes([4.01, 4.04, 4, 4, 4])?.even).toBe(true);
  expect(extremes([])).toBeNull();
});
