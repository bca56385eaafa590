import { expect, test } from "vitest";
import { asTyped, lacksPosition, planRequest, type RunSetup } from "./run-setup";

const setup: RunSetup = {
  goal: "as_taught",
  typed: [],
  start: "as_taught",
  speed: "0.25",
  mode: "held",
};

test("places by name are sent by name", () => {
  expect(planRequest("m", { ...setup, goal: "present", start: "present", speed: "1" })).toEqual({
    model_id: "m",
    start: "present",
    goal: "present",
    speed: 1,
  });
});

test("typed angles are sent as numbers, and only when all six are good", () => {
  const typed = ["1,5", "-2", "3", "4", "5", "6"];
  expect(planRequest("m", { ...setup, goal: "typed", typed })?.goal).toEqual({
    joints_deg: [1.5, -2, 3, 4, 5, 6],
  });
  expect(planRequest("m", { ...setup, goal: "typed", typed: typed.with(0, "x") })).toBeNull();
  expect(planRequest("m", { ...setup, goal: "typed" })).toBeNull();
});

test("angles offered for typing can be read back", () => {
  expect(asTyped([-12.345, 0])).toEqual(["-12.3", "0.0"]);
});

test("a saved position is sent by its id, and only when one is chosen", () => {
  const saved: RunSetup = { ...setup, goal: "saved", start: "saved", goalPosition: "p" };
  expect(planRequest("m", saved)).toBeNull();
  expect(lacksPosition(saved)).toBe(true);
  const both = { ...saved, startPosition: "q" };
  expect(lacksPosition(both)).toBe(false);
  expect(planRequest("m", both)).toMatchObject({
    goal: { position: "p" },
    start: { position: "q" },
  });
  expect(lacksPosition({ ...setup, goalPosition: "p" })).toBe(false);
});
