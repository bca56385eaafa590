import { expect, test } from "vitest";
import { fitted } from "./picture";

test("a photo is made to fit and keeps its proportions; a small one stays", () => {
  expect(fitted(4000, 3000, 512)).toEqual([512, 384]);
  expect(fitted(3000, 4000, 512)).toEqual([384, 512]);
  expect(fitted(300, 200, 512)).toEqual([300, 200]);
  expect(fitted(5000, 2, 512)).toEqual([512, 1]);
});
