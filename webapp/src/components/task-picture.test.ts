import { expect, test } from "vitest";
import { colourOf, initials } from "./task-picture";

test("initials are the first letters of the first two words", () => {
  expect(initials("Load the machine")).toBe("LT");
  expect(initials("  öffnen ")).toBe("Ö");
  expect(initials("(2) Teile — wenden")).toBe("2T");
  expect(initials("…")).toBe("");
});

test("a task's colour stays, and tasks differ", () => {
  expect(colourOf("a")).toBe(colourOf("a"));
  expect(new Set([..."abcdefgh"].map(colourOf)).size).toBeGreaterThan(3);
});
