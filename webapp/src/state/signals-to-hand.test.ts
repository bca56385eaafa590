import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { cueFor, give, mute, muted } from "./signals-to-hand";

const vibrate = vi.fn(() => true);

beforeEach(() => {
  vibrate.mockClear();
  Object.defineProperty(navigator, "vibrate", { value: vibrate, configurable: true });
});
afterEach(() => mute(false));

test("beginning and end of a recording, and the end of a motion, are felt", () => {
  expect(cueFor("preparing", "recording")).toBe("recording began");
  for (const end of ["recorded", "interrupted"]) {
    expect(cueFor("recording", end)).toBe("recording ended");
  }
  for (const end of ["completed", "failed", "stopped"]) {
    expect(cueFor("running", end)).toBe("motion ended");
  }
});

test("what did not happen while this phone looked on is not felt", () => {
  expect(cueFor(undefined, "recording")).toBeNull();
  expect(cueFor(undefined, "completed")).toBeNull();
  expect(cueFor("recorded", "kept")).toBeNull();
  expect(cueFor("running", "running")).toBeNull();
});

test("each sign feels different", () => {
  for (const cue of ["tick", "recording began", "recording ended", "refused"] as const) give(cue);
  const felt = vibrate.mock.calls.map((call) => JSON.stringify(call));
  expect(new Set(felt).size).toBe(4);
});

test("a silent phone stays silent, and remembers it", () => {
  mute(true);
  give("refused");
  expect(vibrate).not.toHaveBeenCalled();
  expect(muted.value).toBe(true);
  expect(localStorage.getItem("team.muted")).toBe("yes");
});

test("a phone that can't vibrate misses nothing", () => {
  Object.defineProperty(navigator, "vibrate", { value: undefined, configurable: true });
  expect(() => give("tick")).not.toThrow();
});
