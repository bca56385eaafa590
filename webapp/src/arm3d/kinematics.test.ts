// Expected places and directions: the same arm by its Denavit-Hartenberg table (theta offset, d, a,
// alpha: 0 265 0 -90; -90 0 444 0; 0 0 110 -90; 0 470 0 90; 0 0 80 -90; 180 101 0 0), multiplied out
// by a program that knows nothing of this one; its derivative by central differences.
import { describe, expect, it } from "vitest";
import { centreLineMm, toolFrame, toolMm, toolMmPerDegree } from "./kinematics";
import { toolSpreadMm } from "./spread";
import type { Vec3 } from "./vector";

const EXPECTED: { deg: number[]; mm: Vec3; x: Vec3; y: Vec3; z: Vec3 }[] = [
  {
    deg: [0, 0, 0, 0, 0, 0],
    mm: [571, 0, 899],
    x: [0, 0, -1],
    y: [0, 1, 0],
    z: [1, 0, 0],
  },
  {
    deg: [39.6, 33.3, 26.7, 42.4, -69.6, 160.4],
    mm: [540.035455, 339.507413, 363.763543],
    x: [-0.044183869, -0.002429329, 0.999020462],
    y: [0.006301504, -0.999977828, -0.002152959],
    z: [0.999003542, 0.006200205, 0.044198197],
  },
  {
    deg: [-170, 80, -200, 120, 90, -260],
    mm: [-7.715473, -90.178356, 738.163763],
    x: [0.727384733, 0.628257554, -0.276050533],
    y: [0.371742446, -0.022615267, 0.928060399],
    z: [0.576817999, -0.777676665, -0.25],
  },
  {
    deg: [12, -45, 60, -81.5, -2.1, 15],
    mm: [243.340351, 136.300285, 550.140428],
    x: [0.123051722, -0.910736361, -0.394230331],
    y: [-0.324001982, 0.338612857, -0.883382164],
    z: [0.938019717, 0.236433105, -0.253413491],
  },
];

const BENT = EXPECTED[1]!.deg;

function near(found: Vec3, expected: readonly number[], digits: number): void {
  found.forEach((value, part) => expect(value).toBeCloseTo(expected[part]!, digits));
}

describe("where the arm is", () => {
  it("agrees with the Denavit-Hartenberg table", () => {
    for (const { deg, mm, x, y, z } of EXPECTED) {
      const frame = toolFrame(deg);
      near(frame.originMm, mm, 5);
      near(frame.x, x, 8);
      near(frame.y, y, 8);
      near(frame.z, z, 8);
    }
  });

  it("goes from the base to the flange with links of the arm's lengths", () => {
    const line = centreLineMm(BENT);
    const gaps = line.slice(1).map((place, part) => {
      const before = line[part]!;
      return Math.hypot(place[0] - before[0], place[1] - before[1], place[2] - before[2]);
    });
    [265, 0, 444, 110, 470, Math.hypot(101, 80)].forEach((length, part) => {
      expect(gaps[part]).toBeCloseTo(length, 9);
    });
    near(line.at(-1)!, toolMm(BENT), 9);
  });
});

describe("how the flange moves", () => {
  it("agrees with differences of the table's places", () => {
    const expected = [
      [-5.92552, 9.4254, 0],
      [1.32817, 1.09876, -11.03946],
      [-3.66236, -3.02977, -6.78494],
      [0.0444, -2.0132, -0.72114],
      [1.46452, 0.60401, -1.59603],
      [0, 0, 0],
    ];
    toolMmPerDegree(BENT).forEach((moved, joint) => near(moved, expected[joint]!, 4));
  });

  it("gives the spread of the place, from an independent eigenvalue", () => {
    expect(toolSpreadMm(BENT, [1, 0.5, 2, 1, 0.7, 3])).toBeCloseTo(17.16431, 3);
  });

  it("is not spread when the joints are not, nor by the turn of the flange alone", () => {
    expect(toolSpreadMm(BENT, [0, 0, 0, 0, 0, 0])).toBeCloseTo(0, 9);
    expect(toolSpreadMm(BENT, [0, 0, 0, 0, 0, 5])).toBeCloseTo(0, 6);
  });

  it("is spread by one joint as far as that joint moves it", () => {
    const [first] = toolMmPerDegree(BENT);
    expect(toolSpreadMm(BENT, [2, 0, 0, 0, 0, 0])).toBeCloseTo(2 * Math.hypot(...first!), 6);
  });
});
