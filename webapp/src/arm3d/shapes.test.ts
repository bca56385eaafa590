// Bodies and tubes are sound: closed, seen from outside, and as big as they should be.
import { describe, expect, it } from "vitest";
import { ARM_PARTS } from "./arm-parts";
import { barrel, laid, link, together, type Solid } from "./solids";
import { apart, tube } from "./tube";
import { cross, dot, length, subtract, unit, type Vec3 } from "./vector";

interface Shape {
  positions: ArrayLike<number>;
  normals: ArrayLike<number>;
  indices: readonly number[];
}

const vertex = (list: ArrayLike<number>, at: number): Vec3 => [
  list[at * 3]!,
  list[at * 3 + 1]!,
  list[at * 3 + 2]!,
];

/** By the divergence theorem: right only for a closed body whose triangles all face outwards. */
function volume({ positions, indices }: Shape): number {
  let sum = 0;
  for (let at = 0; at < indices.length; at += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => vertex(positions, indices[at + corner]!)) as [
      Vec3,
      Vec3,
      Vec3,
    ];
    sum += dot(a, cross(b, c)) / 6;
  }
  return sum;
}

/** Every triangle with an area faces the way that its corners' normals say on the whole. */
function facesOutwards({ positions, normals, indices }: Shape): boolean {
  for (let at = 0; at < indices.length; at += 3) {
    const corners = indices.slice(at, at + 3);
    const [a, b, c] = corners.map((corner) => vertex(positions, corner)) as [Vec3, Vec3, Vec3];
    const face = cross(subtract(b, a), subtract(c, a));
    if (length(face) < 1e-6) continue;
    const agree = corners.map((corner) => dot(unit(face), vertex(normals, corner)));
    if (agree.reduce((sum, one) => sum + one) / 3 < 0.25) return false;
  }
  return true;
}

describe("the bodies of the arm", () => {
  it("have the volume of what they stand for", () => {
    // A polygon of 32 corners has 0.6 % less area than its circle.
    expect(volume(barrel(50, 10, 110, 0.01))).toBeCloseTo(Math.PI * 2500 * 100, -4.3);
    const plate = volume(link(40, 40, 200, 30, 0.01));
    const flat = (Math.PI * 1600 + 200 * 80) * 30;
    expect(plate / flat).toBeGreaterThan(0.99);
    expect(plate / flat).toBeLessThan(1.001);
  });

  it("lose a little at rounded edges and nothing when they are laid another way", () => {
    const sharp = volume(barrel(50, 0, 100, 0.01));
    const round = volume(barrel(50, 0, 100, 10));
    expect(round).toBeLessThan(sharp);
    expect(round).toBeGreaterThan(sharp * 0.94);
    for (const lie of ["about x", "about y", "along x, flat in y"] as const) {
      expect(volume(laid(barrel(50, 0, 100, 10), lie, [7, 8, 9]))).toBeCloseTo(round, 3);
    }
  });

  it("are seen from outside, each of them and all together", () => {
    const all: Solid[] = ARM_PARTS.flat().map((part) => part.solid);
    for (const solid of all) {
      expect(facesOutwards(solid)).toBe(true);
      expect(volume(solid)).toBeGreaterThan(0);
    }
    const one = together(all);
    expect(facesOutwards(one)).toBe(true);
    // What a mid-range phone draws without effort, four times over.
    expect(one.indices.length / 3).toBeLessThan(30_000);
  });
});

describe("a tube along a path", () => {
  const bent: Vec3[] = [
    [0, 0, 0],
    [100, 0, 0],
    [100, 100, 0],
    [100, 100, 100],
  ];

  it("is closed and as thick as asked at each point", () => {
    const straight: Vec3[] = [
      [0, 0, 0],
      [0, 0, 50],
      [0, 0, 100],
    ];
    const shape = tube(straight, (point) => [10, 20, 10][point]!, 64);
    // Two cut cones: pi h (R² + R r + r²) / 3.
    expect(volume(shape) / (2 * ((Math.PI * 50 * 700) / 3))).toBeCloseTo(1, 2);
  });

  it("faces outwards round corners in all directions", () => {
    expect(facesOutwards(tube(bent, () => 5, 12))).toBe(true);
  });

  it("leaves out points where the arm stands still", () => {
    const standing: Vec3[] = [bent[0]!, bent[0]!, [1, 0, 0], bent[1]!, bent[1]!];
    expect(apart(standing, (place) => place, 5)).toEqual([bent[0], bent[1]]);
  });
});
