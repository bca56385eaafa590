import { expect, test } from "vitest";
import { freeName } from "./positions";

test("a new position gets a name that no other has", () => {
  expect(freeName([])).toBe("Position 1");
  expect(freeName(["Fixture", "position 3"])).toBe("Position 4");
});
