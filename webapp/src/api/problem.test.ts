import { expect, test } from "vitest";
import { asProblem, fromDocument, Problem } from "./problem";

test("a refusal keeps its words and says where in the worker's terms", () => {
  const problem = fromDocument(
    {
      code: "motion_refused",
      detail: "Joint 3 would turn too fast.",
      where: { joint: 3, t_s: 2.5049, value: 190.2, demonstration: "0190" },
      advice: "Choose a lower speed.",
    },
    409,
  );
  expect(problem).toMatchObject({
    code: "motion_refused",
    detail: "Joint 3 would turn too fast.",
    where: "joint 3, after 2.5 s",
    advice: "Choose a lower speed.",
    status: 409,
  });
});

test("an answer without a document still says something and what to do", () => {
  const problem = fromDocument({}, 502);
  expect(problem.detail).toContain("502");
  expect(problem.advice).not.toBe("");
  expect(problem.where).toBeNull();
});

test("anything thrown becomes a problem", () => {
  const known = new Problem("a", "b", "c", 409);
  expect(asProblem(known)).toBe(known);
  expect(asProblem(new TypeError("odd")).detail).toBe("odd");
  expect(asProblem("text").detail).toBe("text");
});
