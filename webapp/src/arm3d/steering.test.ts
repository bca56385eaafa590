import { describe, expect, it } from "vitest";
import { toolFrame } from "./kinematics";
import { PACE_MM_S, steered, TURN_DEG_S, type Steered } from "./steering";
import { distance, length, type Vec3 } from "./vector";

const TAKEN = toolFrame([0, 0, 0, 0, 0, 0]);
const START: Steered = { toolMm: TAKEN.originMm, turnDeg: [0, 0, 0] };

describe("a tool led by a button", () => {
  it("is wanted further along at a steady pace", () => {
    const up = { kind: "move", direction: [0, 0, 1] } as const;
    const next = steered(START, up, 0.1, TAKEN, START.toolMm);
    expect(next.toolMm[2] - START.toolMm[2]).toBeCloseTo(PACE_MM_S * 0.1);
    expect(next.turnDeg).toEqual([0, 0, 0]);
  });

  it("is never wanted far ahead of an arm that does not follow", () => {
    let at = START;
    const out = { kind: "move", direction: [1, 0, 0] } as const;
    for (let step = 0; step < 500; step += 1) at = steered(at, out, 0.02, TAKEN, START.toolMm);
    expect(distance(at.toolMm, START.toolMm)).toBeLessThan(100);
    expect(at.toolMm[0]).toBeGreaterThan(START.toolMm[0]);
  });

  it("turns about an axis of the room, told in the flange's own frame", () => {
    // At zero the flange looks along x of the room: its own z is the room's x.
    const about = (axis: Vec3) =>
      steered(START, { kind: "turn", axis }, 0.5, TAKEN, START.toolMm).turnDeg;
    const byX = about([1, 0, 0]);
    expect(byX[2]).toBeCloseTo(TURN_DEG_S / 2);
    expect(length(byX)).toBeCloseTo(TURN_DEG_S / 2);
    expect(about([0, 1, 0])[1]).toBeCloseTo(TURN_DEG_S / 2);
    expect(about([0, 0, 1])[0]).toBeCloseTo(-TURN_DEG_S / 2);
  });
});
