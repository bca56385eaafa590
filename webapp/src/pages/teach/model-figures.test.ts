import { expect, test } from "vitest";
import type { Model } from "../../api/types";
import { modelFigures } from "./model-figures";

const model: Model = {
  id: "m",
  task_id: "t",
  version: 1,
  state: "ready",
  job_id: "j",
  demonstrations: ["a", "b", "c"],
  method: "paper",
  seed: 1,
  created_at: "",
};

test("every figure has its unit", () => {
  const shown = Object.fromEntries(
    modelFigures(model, {
      k: 5,
      e_j_deg: 0.02149,
      gmcc: 0.99871,
      objective: 0.012345,
      fidelity: {
        missed_mean_mm: 1.24,
        missed_max_mm: 7.96,
        mutual_mean_mm: null,
        missed_over_mutual: null,
      },
    }),
  );
  expect(shown).toMatchObject({
    "Gaussians (k)": "5",
    "End error in the joints (e_j)": "0.021°",
    "Likeness of the path (GMCC)": "0.9987",
    Objective: "0.01235",
    "Tool off the shown path on average": "1.2 mm",
    "Tool off the shown path at most": "8.0 mm",
    "Takes used": "3",
  });
});

test("what the report does not have is not shown", () => {
  const shown = modelFigures(model, {}).filter(([, value]) => value !== null);
  expect(shown.map(([name]) => name)).toEqual(["Takes used", "Method"]);
});
