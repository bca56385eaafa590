// What is asserted here is geometry that can be reckoned on paper.
import { describe, expect, it } from "vitest";
import { distance, dot, length, subtract, type Vec3 } from "./vector";
import {
  blend,
  directionOf,
  eye,
  FIELD_DEG,
  from,
  nearer,
  onScreen,
  overview,
  turned,
  underFinger,
  VIEWS,
  type Viewpoint,
} from "./viewpoint";

const SIZE = { width: 390, height: 300 };
const SIDE: Viewpoint = {
  centreMm: [0, 0, 500],
  distanceMm: 2000,
  azimuthDeg: -90,
  elevationDeg: 0,
};
const OBLIQUE: Viewpoint = { ...SIDE, azimuthDeg: -38, elevationDeg: 20 };

describe("the picture", () => {
  it("seen from the arm's right side has its front on the right and up above", () => {
    const middle = onScreen(SIDE, SIZE, [0, 0, 500]);
    expect(middle.x).toBeCloseTo(195);
    expect(middle.y).toBeCloseTo(150);
    expect(onScreen(SIDE, SIZE, [100, 0, 500]).x).toBeGreaterThan(middle.x);
    expect(onScreen(SIDE, SIZE, [0, 0, 600]).y).toBeLessThan(middle.y);
  });

  it("is as high as its field of view at the distance of what is looked at", () => {
    const half = 2000 * Math.tan((FIELD_DEG / 2) * (Math.PI / 180));
    expect(onScreen(SIDE, SIZE, [0, 0, 500 + half]).y).toBeCloseTo(0);
    expect(onScreen(SIDE, SIZE, [0, 0, 500]).mmPerPixel).toBeCloseTo((2 * half) / 300);
  });

  it("holds everything it was made for, with room, on any shape of screen", () => {
    const places: Vec3[] = [
      [0, 0, 0],
      [600, -400, 900],
      [-300, 500, 100],
    ];
    for (const size of [SIZE, { width: 360, height: 200 }, { width: 300, height: 700 }]) {
      for (const name of ["oblique", "front", "side", "top"] as const) {
        const view = overview(places, size, name);
        for (const place of places) {
          const { x, y } = onScreen(view, size, place);
          expect(x).toBeGreaterThan(0);
          expect(x).toBeLessThan(size.width);
          expect(y).toBeGreaterThan(0);
          expect(y).toBeLessThan(size.height);
        }
      }
    }
  });
});

describe("a finger on the picture", () => {
  it("points at the place that is drawn under it", () => {
    const place: Vec3 = [320, -140, 610];
    const { x, y } = onScreen(OBLIQUE, SIZE, place);
    expect(distance(underFinger(OBLIQUE, SIZE, x, y, place), place)).toBeLessThan(1e-9);
  });

  it("moves what it holds in the plane that faces the eye, and with the finger", () => {
    const held: Vec3 = [320, -140, 610];
    const start = onScreen(OBLIQUE, SIZE, held);
    const moved = underFinger(OBLIQUE, SIZE, start.x + 50, start.y - 30, held);
    expect(dot(subtract(moved, held), eye(OBLIQUE).ahead)).toBeCloseTo(0, 9);
    const end = onScreen(OBLIQUE, SIZE, moved);
    expect(end.x - start.x).toBeCloseTo(50);
    expect(end.y - start.y).toBeCloseTo(-30);
    expect(distance(moved, held)).toBeCloseTo(Math.hypot(50, 30) * start.mmPerPixel);
  });
});

describe("turning and coming nearer", () => {
  it("never goes under the floor or over the top, nor into the arm", () => {
    let view = SIDE;
    for (let press = 0; press < 20; press += 1) view = nearer(turned(view, 30, 20), 1.5);
    expect(view.elevationDeg).toBeLessThan(90);
    expect(view.distanceMm).toBeGreaterThan(100);
    for (let press = 0; press < 40; press += 1) view = nearer(turned(view, 0, -20), 1 / 1.5);
    expect(view.elevationDeg).toBeGreaterThan(-20);
    expect(view.distanceMm).toBeLessThan(10_000);
  });

  it("goes to a named view the short way round", () => {
    const far = turned(SIDE, 360 + 80, 0);
    const front = from(far, "front");
    expect(Math.abs(front.azimuthDeg - far.azimuthDeg)).toBeLessThanOrEqual(180);
    expect(eye(front).ahead[0]).toBeCloseTo(eye({ ...far, ...VIEWS.front }).ahead[0]);
  });

  it("begins and ends a turn where it should", () => {
    const to = turned(SIDE, 40, 10);
    expect(blend(SIDE, to, 0)).toEqual(SIDE);
    expect(blend(SIDE, to, 1).azimuthDeg).toBeCloseTo(to.azimuthDeg);
  });
});

describe("ways as the one who looks means them", () => {
  it("are level, except up and down, from wherever the picture is seen", () => {
    for (const view of [SIDE, OBLIQUE, { ...SIDE, elevationDeg: 89.9 }]) {
      for (const way of ["left", "right", "forward", "back"] as const) {
        const direction = directionOf(view, way);
        expect(direction[2]).toBeCloseTo(0, 6);
        expect(length(direction)).toBeCloseTo(1, 6);
      }
      expect(directionOf(view, "up")).toEqual([0, 0, 1]);
    }
    expect(directionOf(SIDE, "right")[0]).toBeCloseTo(1);
    expect(directionOf(SIDE, "forward")[1]).toBeCloseTo(1);
  });
});
