import { expect, test } from "vitest";
import type { RobotView } from "../api/types";
import { robotStatus, whyNotReady } from "./robot-status";

const view = (state: RobotView["state"], ageMs = 20): RobotView => ({
  id: "left",
  name: "Left arm",
  kind: "virtual",
  state,
  age_ms: ageMs,
  signals: [],
  continuous_run: true,
  egm: { connected: false, cycles: 0, lost: 0, late: 0, real_time: false },
});

test("fresh data is shown with its state", () => {
  const status = robotStatus(view("idle"), "live", 40);
  expect(status).toMatchObject({ word: "Ready", tone: "good", stale: false });
});

test("an arm that does not answer is told from a server without one", () => {
  const silent = view("disconnected");
  expect(robotStatus(silent, "live", 0).word).toBe("Not connected");
  expect(robotStatus({ ...silent, kind: "none" }, "live", 0).word).toBe("No robot");
});

test("old joints are shown as old although the connection is alive", () => {
  const status = robotStatus(view("idle", 4000), "live", 0);
  expect(status).toMatchObject({ tone: "stale", stale: true, age: "old: 4 s" });
});

test("without connection the last state is shown as past, with its growing age", () => {
  const status = robotStatus(view("reproducing"), "lost", 61_000);
  expect(status).toMatchObject({ stale: true, word: "Offline", age: "Moving, 1:01 min ago" });
});

test("every state that forbids a start says why", () => {
  expect(whyNotReady(view("idle"), "live")).toBeNull();
  expect(whyNotReady(view("guiding"), "live", true)).toBeNull();
  for (const state of ["guiding", "reproducing", "stopping", "faulted", "disconnected"] as const) {
    expect(whyNotReady(view(state), "live")).toMatch(/\w+\./);
  }
  expect(whyNotReady(view("idle"), "lost")).toMatch(/not connected/);
});
