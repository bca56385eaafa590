import { expect, test } from "vitest";
import { JointRing } from "./ring-buffer";

const joints = (value: number) => [value, value + 1, value + 2, value + 3, value + 4, value + 5];

test("keeps the newest samples in order when it is full", () => {
  const ring = new JointRing(3);
  for (let index = 0; index < 5; index += 1) ring.push(index, joints(10 * index));
  expect(ring.length).toBe(3);
  const [times, first, , , , , last] = ring.window(100);
  expect(times).toEqual([-2, -1, 0]);
  expect(first).toEqual([20, 30, 40]);
  expect(last).toEqual([25, 35, 45]);
});

test("the window leaves out what is older", () => {
  const ring = new JointRing(10);
  for (let index = 0; index < 5; index += 1) ring.push(index, joints(index));
  expect(ring.window(1.5)[0]).toEqual([-1, 0]);
});

test("samples that repeat a time or lack joints are left out", () => {
  const ring = new JointRing(10);
  ring.push(1, joints(0));
  ring.push(1, joints(5));
  ring.push(0.5, joints(5));
  ring.push(2, [1, 2, 3]);
  expect(ring.revision).toBe(1);
  expect(ring.window(10).slice(0, 2)).toEqual([[0], [0]]);
});

test("empty after clearing, and time may start again", () => {
  const ring = new JointRing(4);
  ring.push(100, joints(1));
  ring.clear();
  expect(ring.window(10)[0]).toEqual([]);
  ring.push(1, joints(1));
  expect(ring.length).toBe(1);
});
