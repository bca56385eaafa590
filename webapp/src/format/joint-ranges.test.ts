import { expect, test } from "vitest";
import { checkJoint, readJoints } from "./joint-ranges";

test("each joint has its own range", () => {
  expect(checkJoint(2, "85")).toBe("ok");
  expect(checkJoint(2, "85,1")).toBe("out_of_range");
  expect(checkJoint(2, "-225")).toBe("ok");
  expect(checkJoint(5, "269.9")).toBe("ok");
  expect(checkJoint(0, "abc")).toBe("not_number");
  expect(checkJoint(6, "0")).toBe("not_number");
});

test("six good numbers become joint angles, anything else does not", () => {
  expect(readJoints(["1", "2,5", "-3", "0", "90", "-270"])).toEqual([1, 2.5, -3, 0, 90, -270]);
  expect(readJoints(["1", "2", "90", "0", "90", "0"])).toBeNull();
  expect(readJoints(["1", "2", "", "0", "90", "0"])).toBeNull();
  expect(readJoints(["1"])).toBeNull();
});
