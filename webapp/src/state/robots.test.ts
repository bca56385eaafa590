import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { RobotView } from "../api/types";
import { chooseRobot, isOurs, loadRobots, robotId } from "./robots";

const robot = (id: string): RobotView => ({
  id,
  name: id,
  kind: "virtual",
  state: "idle",
  age_ms: 0,
  signals: [],
  continuous_run: true,
  egm: { connected: false, cycles: 0, lost: 0, late: 0, real_time: false },
});
const answer = (...ids: string[]) =>
  vi.stubGlobal("fetch", async () => new Response(JSON.stringify(ids.map(robot))));

beforeEach(() => {
  localStorage.clear();
  robotId.value = "";
});
afterEach(() => vi.unstubAllGlobals());

test("a single robot needs no choice, whatever the phone remembers", async () => {
  chooseRobot("right");
  robotId.value = "";
  answer("left");
  await loadRobots();
  expect(robotId.value).toBe("left");
});

test("with several robots a person chooses once, and the phone remembers it", async () => {
  answer("left", "right");
  await loadRobots();
  expect(robotId.value).toBe("");
  chooseRobot("right");
  robotId.value = "";
  await loadRobots();
  expect(robotId.value).toBe("right");
});

test("when the chosen robot is gone the phone does not go on with another by itself", async () => {
  chooseRobot("right");
  answer("left", "middle");
  await loadRobots();
  expect(robotId.value).toBe("");
});

test("another robot's work is not this one's", () => {
  robotId.value = "left";
  expect([{ robot: "left" }, { robot: "right" }, {}].map(isOurs)).toEqual([true, false, true]);
});
