import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { LiveSocket } from "./socket";

class FakeSocket {
  static readonly OPEN = 1;
  static all: FakeSocket[] = [];
  static get last(): FakeSocket {
    return FakeSocket.all.at(-1)!;
  }
  readyState = 0;
  sent: string[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: (() => void) | null = null;
  constructor(readonly url: string) {
    FakeSocket.all.push(this);
  }
  accept(): void {
    this.readyState = 1;
    this.onopen?.();
  }
  say(data: unknown): void {
    this.onmessage?.({ data: typeof data === "string" ? data : JSON.stringify(data) });
  }
  send(text: string): void {
    this.sent.push(text);
  }
  close(): void {
    this.readyState = 3;
    this.onclose?.();
  }
}

let states: string[];
let messages: string[];
let live: LiveSocket;

beforeEach(() => {
  vi.useFakeTimers();
  vi.spyOn(Math, "random").mockReturnValue(0);
  vi.stubGlobal("WebSocket", FakeSocket);
  FakeSocket.all = [];
  states = [];
  messages = [];
  live = new LiveSocket("ws://robot/live", {
    state: (state) => states.push(state),
    message: (message) => messages.push(message.type),
  });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

test("nothing counts before the snapshot", () => {
  live.open();
  FakeSocket.last.accept();
  FakeSocket.last.say({ type: "robot" });
  FakeSocket.last.say("no JSON");
  expect(messages).toEqual([]);
  FakeSocket.last.say({ type: "snapshot" });
  FakeSocket.last.say({ type: "robot" });
  expect(states).toEqual(["connecting", "identifying", "live"]);
  expect(messages).toEqual(["snapshot", "robot"]);
});

test("a lost connection is tried again later and later, and needs a new snapshot", () => {
  live.open();
  FakeSocket.last.accept();
  FakeSocket.last.say({ type: "snapshot" });
  FakeSocket.last.close();
  expect(states.at(-1)).toBe("lost");
  vi.advanceTimersByTime(499);
  expect(FakeSocket.all).toHaveLength(1);
  vi.advanceTimersByTime(1);
  expect(FakeSocket.all).toHaveLength(2);
  FakeSocket.last.close();
  vi.advanceTimersByTime(699);
  expect(FakeSocket.all).toHaveLength(2);
  vi.advanceTimersByTime(1);
  FakeSocket.last.accept();
  FakeSocket.last.say({ type: "robot" });
  expect(messages).toEqual(["snapshot"]);
});

test("a connection that was closed for good is not tried again", () => {
  live.open();
  FakeSocket.last.accept();
  FakeSocket.last.say({ type: "snapshot" });
  live.close();
  expect(states.at(-1)).toBe("lost");
  vi.advanceTimersByTime(60_000);
  live.close();
  expect(FakeSocket.all).toHaveLength(1);
});

test("silence is noticed", () => {
  live.open();
  FakeSocket.last.accept();
  FakeSocket.last.say({ type: "snapshot" });
  vi.advanceTimersByTime(2999);
  expect(states.at(-1)).toBe("live");
  vi.advanceTimersByTime(1);
  expect(states.at(-1)).toBe("lost");
});

test("a message goes out only on an open connection", () => {
  expect(live.send({ type: "stop" })).toBe(false);
  live.open();
  expect(live.send({ type: "stop" })).toBe(false);
  FakeSocket.last.accept();
  expect(live.send({ type: "stop" })).toBe(true);
  expect(FakeSocket.last.sent).toEqual(['{"type":"stop"}']);
});
