import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { useWakeLock } from "./wake-lock";

class Lock {
  released = false;
  release = vi.fn(() => {
    this.released = true;
    return Promise.resolve();
  });
}

let locks: Lock[] = [];
let refuse = false;
const place = document.createElement("div");

function Screen({ awake }: { awake: boolean }) {
  useWakeLock(awake);
  return null;
}

async function show(awake: boolean, key = "one") {
  await act(async () => render(<Screen key={key} awake={awake} />, place));
}

beforeEach(() => {
  vi.useFakeTimers();
  locks = [];
  refuse = false;
  const request = () => {
    if (refuse) return Promise.reject(new Error("NotAllowedError"));
    locks.push(new Lock());
    return Promise.resolve(locks.at(-1));
  };
  Object.defineProperty(navigator, "wakeLock", { value: { request }, configurable: true });
});

afterEach(async () => {
  await act(async () => render(null, place));
  await vi.runAllTimersAsync();
  vi.useRealTimers();
});

test("the screen stays on while it is wanted, and not longer", async () => {
  await show(false);
  expect(locks).toHaveLength(0);
  await show(true);
  expect(locks).toHaveLength(1);
  await show(false);
  await vi.runAllTimersAsync();
  expect(locks[0]?.released).toBe(true);
});

test("from one screen to the next the same lock is kept", async () => {
  await show(true, "count-in");
  await show(true, "recording");
  await vi.runAllTimersAsync();
  expect(locks).toHaveLength(1);
  expect(locks[0]?.released).toBe(false);
});

test("a lock that the phone took away is asked for again when the page is seen again", async () => {
  await show(true);
  locks[0]!.released = true;
  document.dispatchEvent(new Event("visibilitychange"));
  await vi.advanceTimersByTimeAsync(0);
  expect(locks).toHaveLength(2);
});

test("what was refused is asked for again with the next touch", async () => {
  refuse = true;
  await show(true);
  expect(locks).toHaveLength(0);
  refuse = false;
  document.dispatchEvent(new Event("pointerup"));
  await vi.advanceTimersByTimeAsync(0);
  expect(locks).toHaveLength(1);
});

test("after it is let go nothing asks any more", async () => {
  await show(true);
  await show(false);
  await vi.runAllTimersAsync();
  document.dispatchEvent(new Event("pointerup"));
  await vi.advanceTimersByTimeAsync(0);
  expect(locks).toHaveLength(1);
});
