import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { ArmDrag, dragLost, EVERY_MS } from "./arm-drag";

let sent: object[];
let connected: boolean;
const make = () =>
  new ArmDrag((message) => {
    if (connected) sent.push(message);
    return connected;
  });

beforeEach(() => {
  vi.useFakeTimers();
  sent = [];
  connected = true;
});
afterEach(() => {
  vi.useRealTimers();
});

describe("leading the virtual arm", () => {
  it("says the first place at once and at most thirty a second after it", () => {
    const drag = make();
    drag.begin();
    drag.move({ tool_mm: [1, 2, 3] });
    expect(sent).toEqual([{ type: "drag", tool_mm: [1, 2, 3] }]);
    for (let ms = 0; ms < 1000; ms += 4) {
      drag.move({ tool_mm: [ms, 0, 0] });
      vi.advanceTimersByTime(4);
    }
    expect(sent.length).toBeGreaterThan(15);
    expect(sent.length).toBeLessThanOrEqual(30);
    expect(sent.at(-1)).toEqual({ type: "drag", tool_mm: [996, 0, 0] });
    drag.end();
  });

  it("goes on saying where a resting finger is, so that the arm is not let go", () => {
    const drag = make();
    drag.begin();
    drag.move({ tool_mm: [1, 2, 3] });
    vi.advanceTimersByTime(10 * EVERY_MS);
    expect(sent).toHaveLength(11);
    drag.end();
  });

  it("says once that it was let go, and nothing after", () => {
    const drag = make();
    drag.begin();
    drag.move({ tool_mm: [1, 2, 3] });
    drag.end();
    drag.end();
    drag.move({ tool_mm: [9, 9, 9] });
    vi.advanceTimersByTime(1000);
    expect(sent.slice(1)).toEqual([{ type: "drag_end" }]);
  });

  it("says nothing when the ball was only touched", () => {
    const drag = make();
    drag.begin();
    drag.end();
    expect(sent).toEqual([]);
  });

  it("lets go and says so when the connection is lost", () => {
    const drag = make();
    drag.begin();
    drag.move({ tool_mm: [1, 2, 3] });
    connected = false;
    vi.advanceTimersByTime(EVERY_MS);
    expect(drag.held).toBe(false);
    expect(dragLost.value).toBe(true);
    connected = true;
    vi.advanceTimersByTime(1000);
    expect(sent).toHaveLength(1);
  });
});
