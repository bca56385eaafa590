import { expect, test } from "vitest";
import type { Model, Report } from "../../api/types";
import { verdictOf } from "./verdict";

const good: Report = {
  e_j_deg: 0.02,
  gmcc: 0.999,
  agreement: { enough: true, advice: "" },
  fidelity: { missed_mean_mm: 3, missed_max_mm: 9, mutual_mean_mm: 5, missed_over_mutual: 0.6 },
};
const light = (report: Report, takes = 3) => {
  const model = { report, demonstrations: Array.from({ length: takes }, String) };
  return verdictOf(model as unknown as Model).light;
};
const path = (missed: number, mutual: number) => ({
  fidelity: {
    missed_mean_mm: missed,
    missed_max_mm: 2 * missed,
    mutual_mean_mm: mutual,
    missed_over_mutual: missed / mutual,
  },
});

test("green needs a path within the takes' own spread and takes that agree", () => {
  expect(light(good)).toBe("green");
  expect(light({ ...good, ...path(6, 5) })).toBe("amber");
  expect(light({ ...good, agreement: { enough: false, advice: "" } })).toBe("amber");
  expect(light({ ...good, fidelity: null }, 1)).toBe("amber");
});

test("a motion that is not what was shown is red", () => {
  expect(light({ ...good, ...path(30, 5) })).toBe("red");
  expect(light({ ...good, e_j_deg: 2 })).toBe("red");
  expect(light({ ...good, gmcc: 0.5 })).toBe("red");
  // Takes that lie very close together make a small distance look large.
  expect(light({ ...good, ...path(1.5, 0.5) })).toBe("amber");
});
