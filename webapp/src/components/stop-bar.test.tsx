import { render } from "preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { t } from "../texts";
import { StopBar } from "./stop-bar";

let place: HTMLElement;
const button = () => place.querySelector("button")!;
const words = () => place.querySelector("[role=status]")!.textContent;

beforeEach(() => {
  place = document.createElement("div");
  document.body.append(place);
});
afterEach(() => {
  render(null, place);
  place.remove();
  vi.unstubAllGlobals();
});

test("stop goes out at the first touch, over HTTP when there is no live connection, and to every robot while none is chosen", async () => {
  const fetch = vi.fn().mockResolvedValue(new Response(null, { status: 204 }));
  vi.stubGlobal("fetch", fetch);
  render(<StopBar />, place);
  button().dispatchEvent(new Event("pointerdown", { bubbles: true }));
  expect(fetch).toHaveBeenCalledExactlyOnceWith(
    "/api/v1/robots/stop",
    expect.objectContaining({ method: "POST", keepalive: true }),
  );
  await vi.waitFor(() => expect(words()).toBe(t.stop.sent));
});

test("a stop that does not get through says so", async () => {
  vi.stubGlobal("fetch", vi.fn().mockRejectedValue(new TypeError("no network")));
  render(<StopBar />, place);
  button().click();
  await vi.waitFor(() => expect(words()).toBe(t.stop.failed));
});

test("a stop that nobody answers is said to have failed, and a late answer corrects it", async () => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
  let answer: (response: Response) => void = () => undefined;
  vi.stubGlobal("fetch", () => new Promise<Response>((resolve) => (answer = resolve)));
  render(<StopBar />, place);
  button().click();
  await vi.waitFor(() => expect(words()).toBe(t.stop.sending));
  await vi.advanceTimersByTimeAsync(5000);
  await vi.waitFor(() => expect(words()).toBe(t.stop.failed));
  answer(new Response(null, { status: 204 }));
  vi.useRealTimers();
  await vi.waitFor(() => expect(words()).toBe(t.stop.sent));
});
