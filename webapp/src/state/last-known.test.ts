import { beforeEach, expect, test } from "vitest";
import type { RobotView } from "../api/types";
import { keepRobot, lastKnown } from "./last-known";

const view = (state: string) => ({ id: "left", state }) as RobotView;
let now = 1_000_000;

beforeEach(() => {
  localStorage.clear();
  now += 1_000_000;
});

test("what was heard last is known after a new start, with its time", () => {
  expect(lastKnown(now)).toBeNull();
  keepRobot(view("idle"), now);
  expect(lastKnown(now + 60_000)).toEqual({ view: view("idle"), atMs: now });
});

test("it is written once a second, however much the robot says", () => {
  keepRobot(view("idle"), now);
  keepRobot(view("guiding"), now + 999);
  expect(lastKnown(now)?.view.state).toBe("idle");
  keepRobot(view("guiding"), now + 1000);
  expect(lastKnown(now + 1000)?.view.state).toBe("guiding");
});

test("it never comes from the future", () => {
  keepRobot(view("idle"), now);
  expect(lastKnown(now - 5000)?.atMs).toBe(now - 5000);
});

test("what cannot be read, or is of another build, is nothing", () => {
  for (const text of ["", "{", "null", '{"build":"/assets/other.js","view":{},"atMs":1}']) {
    localStorage.setItem("team.last-known", text);
    expect(lastKnown(now), text).toBeNull();
  }
});
