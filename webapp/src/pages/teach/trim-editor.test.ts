import { expect, test } from "vitest";
import { moved } from "./trim-editor";

const span = { from_s: 0, to_s: 5.03 };
const near = (value: number): unknown => expect.closeTo(value, 6);

test("an end moves by steps and stays within the take", () => {
  expect(moved(span, "from_s", 0.14, 5.03)).toEqual({ from_s: near(0.1), to_s: 5.03 });
  expect(moved(span, "from_s", -3, 5.03).from_s).toBe(0);
  expect(moved(span, "to_s", 4.93, 5.03).to_s).toEqual(near(4.9));
  expect(moved(span, "to_s", 5, 5.03).to_s).toBe(5.03);
  expect(moved({ ...span, to_s: 4.9 }, "to_s", 5.0, 5.03).to_s).toBe(5.03);
});

test("the ends never come closer than what can be learnt from", () => {
  expect(moved(span, "from_s", 9, 5.03).from_s).toEqual(near(3.93));
  expect(moved({ from_s: 2, to_s: 5 }, "to_s", 0, 5.03).to_s).toEqual(near(3.1));
});
