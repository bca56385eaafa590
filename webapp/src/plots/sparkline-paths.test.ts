import { expect, test } from "vitest";
import { sparklinePaths } from "./sparkline-paths";

test("the widest joint fills the height, others keep the scale", () => {
  const [wide, flat] = sparklinePaths(
    [0, 1, 2],
    [
      [0, 10, 20],
      [7, 7, 7],
    ],
    100,
    50,
  );
  expect(wide).toBe("M2.0 48.0L50.0 25.0L98.0 2.0");
  expect(flat).toBe("M2.0 25.0L50.0 25.0L98.0 25.0");
});

test("nothing recorded draws nothing", () => {
  expect(sparklinePaths([], [[], []], 100, 50)).toEqual(["", ""]);
});
