import { expect, test } from "vitest";
import { backOffMs, mayFollow, type ConnectionState } from "./connection";

const STATES: ConnectionState[] = ["connecting", "identifying", "live", "lost"];

test("the connection is live only after the snapshot, and starts anew only when lost", () => {
  const allowed = STATES.flatMap((from) =>
    STATES.filter((to) => mayFollow(from, to)).map((to) => `${from}>${to}`),
  );
  expect(allowed).toEqual([
    "connecting>identifying",
    "connecting>lost",
    "identifying>live",
    "identifying>lost",
    "live>lost",
    "lost>connecting",
  ]);
});

test("waits grow by 1.4 from half a second to five seconds", () => {
  expect(backOffMs(0, 0)).toBe(500);
  expect(backOffMs(1, 0)).toBeCloseTo(700);
  expect(backOffMs(2, 0)).toBeCloseTo(980);
  expect(backOffMs(6, 0)).toBeCloseTo(3764.77, 1);
  expect(backOffMs(7, 0)).toBe(5000);
  expect(backOffMs(1000, 0)).toBe(5000);
});

test("phones that lost the server together come back at different times", () => {
  expect(backOffMs(0, 1)).toBeCloseTo(650);
  expect(backOffMs(1000, 1)).toBeCloseTo(6500);
});
