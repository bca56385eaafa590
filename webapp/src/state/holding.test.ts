import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { RobotView } from "../api/types";
import { beginHolding } from "./holding";
import { connection } from "./live";
import * as live from "./live";

let said: string[];

beforeEach(() => {
  vi.useFakeTimers();
  said = [];
  connection.value = "live";
  vi.spyOn(live, "hold").mockImplementation(() => {
    said.push("hold");
    return connection.peek() === "live";
  });
  vi.spyOn(live, "letGo").mockImplementation(() => void said.push("let go"));
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

function begin() {
  const ended = vi.fn();
  const stop = beginHolding("motion", ended);
  vi.advanceTimersByTime(500);
  return { ended, stop };
}

/** Whatever it was, it ended the holding once, and nothing is said after it. */
function expectLetGo(ended: ReturnType<typeof vi.fn>) {
  expect(ended).toHaveBeenCalledTimes(1);
  expect(said.at(-1)).toBe("let go");
  const so = said.length;
  vi.advanceTimersByTime(1000);
  expect(said.length).toBe(so);
}

test("it is said at once and then far more often than the server's patience of 180 ms", () => {
  const { stop, ended } = begin();
  expect(said.filter((word) => word === "hold").length).toBeGreaterThanOrEqual(8);
  stop();
  stop();
  expectLetGo(ended);
});

test("a call coming in, a locked phone, another window: nobody holds it any more", () => {
  for (const [target, name] of [
    [window, "blur"],
    [window, "pagehide"],
    [document, "visibilitychange"],
  ] as const) {
    const { ended } = begin();
    target.dispatchEvent(new Event(name));
    expectLetGo(ended);
  }
});

test("a press that the server heard nothing of for a while is over", async () => {
  const run = (held: boolean) =>
    ({
      run: { phase: "motion", speed: 1, paused: false, held, t_s: 1, duration_s: 9 },
    }) as RobotView;
  live.robot.value = run(false);
  const { ended } = begin();
  expect(ended).not.toHaveBeenCalled();
  live.robot.value = run(true);
  live.robot.value = run(false);
  await Promise.resolve();
  expectLetGo(ended);
  live.robot.value = null;
});

test("a lost connection ends it, and it does not begin again by itself", async () => {
  const { ended } = begin();
  connection.value = "lost";
  await Promise.resolve();
  expectLetGo(ended);
  connection.value = "live";
  await Promise.resolve();
  expect(ended).toHaveBeenCalledTimes(1);
});
