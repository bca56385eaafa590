import { expect, test } from "vitest";
import { axisLabels } from "./axis-numbers";

test("an axis has the decimals that its step needs", () => {
  expect(axisLabels([-20, 0, 20], 20)).toEqual(["−20", "0", "20"]);
  expect(axisLabels([0, 0.5, 1], 0.5)).toEqual(["0.0", "0.5", "1.0"]);
  expect(axisLabels([0, 0.25, 0.5], 0.25)).toEqual(["0.00", "0.25", "0.50"]);
  expect(axisLabels([0, 2.5, 5], 2.5)).toEqual(["0.0", "2.5", "5.0"]);
  expect(axisLabels([0, 0.1, 0.2], 0.1)).toEqual(["0.0", "0.1", "0.2"]);
});
