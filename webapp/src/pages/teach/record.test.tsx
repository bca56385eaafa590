import { render } from "preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { RobotView } from "../../api/types";
import { leader } from "../../state/hand-script";
import { connection, robot } from "../../state/live";
import { recordAtOnce } from "../../state/next-take";
import { t } from "../../texts";
import { RecordPage } from "./record";

const view = (kind: RobotView["kind"], state: RobotView["state"]): RobotView => ({
  id: "left",
  name: "Left arm",
  kind,
  state,
  age_ms: 0,
  egm: { connected: false, cycles: 0, lost: 0, late: 0, real_time: false },
  signals: [],
  continuous_run: true,
});

let place: HTMLElement;
let asked: string[];
const button = (name: string) =>
  [...place.querySelectorAll("button")].find((one) => one.textContent === name);

beforeEach(() => {
  place = document.createElement("div");
  document.body.append(place);
  asked = [];
  vi.stubGlobal("fetch", async (path: string, { body }: RequestInit) => {
    asked.push(`${path} ${body ?? ""}`);
    return new Response("{}");
  });
  connection.value = "live";
});
afterEach(() => {
  render(null, place);
  place.remove();
  robot.value = null;
  vi.unstubAllGlobals();
});

test("the next take of a real arm waits until it is ready, and makes it soft to be brought back", async () => {
  robot.value = view("gofa", "stopping");
  recordAtOnce("t");
  render(<RecordPage task="t" />, place);
  expect(place.textContent).toContain(t.teaching.next.wait);
  expect(asked).toEqual([]);
  robot.value = view("gofa", "idle");
  await vi.waitFor(() => expect(place.textContent).toContain(t.teaching.next.bringBack));
  expect(asked).toEqual([expect.stringContaining('/lead-through {"active":true}')]);
  button(t.teaching.next.more)!.click();
  await vi.waitFor(() =>
    expect(Number(place.querySelector(".count")!.textContent)).toBeGreaterThan(10),
  );

  button(t.app.cancel)!.click();
  await vi.waitFor(() => expect(button(t.teach.startRecording)).toBeDefined());
  expect(asked[1]).toContain('/lead-through {"active":false}');
});

test("a virtual hand needs nobody to bring the arm back", async () => {
  leader.value = "f1";
  robot.value = view("virtual", "idle");
  recordAtOnce("t");
  render(<RecordPage task="t" />, place);
  await vi.waitFor(() => expect(place.querySelector(".count")!.textContent).toBe("3"));
  expect(asked).toEqual([]);
});

test("whoever leads the virtual arm by a finger brings it back like a real one", async () => {
  leader.value = "self";
  robot.value = view("virtual", "idle");
  recordAtOnce("t");
  render(<RecordPage task="t" />, place);
  await vi.waitFor(() => expect(place.textContent).toContain(t.teaching.next.bringBack));
  expect(asked).toEqual([expect.stringContaining('/lead-through {"active":true}')]);
  button(t.app.cancel)!.click();
  await vi.waitFor(() => expect(button(t.teach.startRecording)).toBeDefined());
});

test("a page that is only opened makes no arm soft", async () => {
  robot.value = view("gofa", "idle");
  recordAtOnce("another");
  render(<RecordPage task="t" />, place);
  expect(button(t.teach.startRecording)).toBeDefined();
  // It was asked for once, and not here: it is forgotten.
  render(null, place);
  render(<RecordPage task="another" />, place);
  expect(button(t.teach.startRecording)).toBeDefined();
  expect(asked).toEqual([]);
});
