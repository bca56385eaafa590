import { render } from "preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { RobotView } from "../api/types";
import { connection, robot } from "../state/live";
import { t } from "../texts";
import { SignalButtons } from "./signal-buttons";
import { SignalTimes } from "./signal-times";

let place: HTMLElement;
const button = () => place.querySelector("button")!;

const view = (is_on: boolean | null, state: RobotView["state"] = "guiding"): RobotView => ({
  id: "virtual",
  name: "Virtual",
  kind: "virtual",
  state,
  age_ms: 0,
  egm: { connected: false, cycles: 0, lost: 0, late: 0, real_time: false },
  continuous_run: true,
  signals: [{ name: "Gripper/Close", label: "Gripper", on: "close", off: "open", is_on }],
});

beforeEach(() => {
  place = document.createElement("div");
  document.body.append(place);
  connection.value = "live";
});
afterEach(() => {
  render(null, place);
  place.remove();
  robot.value = null;
  vi.unstubAllGlobals();
});

test("the button says how the gripper stands and does the opposite", async () => {
  const fetch = vi.fn().mockResolvedValue(new Response("{}", { status: 200 }));
  vi.stubGlobal("fetch", fetch);
  robot.value = view(false);
  render(<SignalButtons />, place);
  expect(place.textContent).toContain(t.signals.stands("Gripper", "open"));
  expect(button().textContent).toBe("Gripper: close");
  button().click();
  await vi.waitFor(() => expect(fetch).toHaveBeenCalledOnce());
  expect(fetch.mock.calls[0]![0]).toBe("/api/v1/robots/virtual/signals/Gripper%2FClose");
  expect(fetch.mock.calls[0]![1].body).toBe('{"on":true}');

  robot.value = view(true);
  await vi.waitFor(() => expect(button().textContent).toBe("Gripper: open"));
});

test("a button that cannot be pressed says why", () => {
  const cases: [RobotView, "live" | "lost", string][] = [
    [view(null), "live", t.signals.unknown("Gripper")],
    [view(true, "reproducing"), "live", t.signals.notWhileMoving],
    [view(true), "lost", t.robot.why.offline],
  ];
  for (const [shown, state, why] of cases) {
    robot.value = shown;
    connection.value = state;
    render(<SignalButtons />, place);
    expect(button().disabled).toBe(true);
    expect(place.textContent).toContain(why);
    render(null, place);
  }
});

test("a cell without signals has no buttons, and unknown signals keep their name", () => {
  robot.value = { ...view(true), signals: [] };
  render(<SignalButtons />, place);
  expect(place.textContent).toBe("");
  render(<SignalTimes title="Worked" marks={[{ name: "Vacuum", at_s: 2, on: true }]} />, place);
  expect(place.querySelector("li")!.textContent).toContain("Vacuum: 1");
});
