// Where the picture is seen from, and what a finger on it points at. Right-handed, z up, in
// millimetres; pixels from the upper left corner of the picture.
import { add, cross, dot, length, scale, subtract, unit, type Vec3 } from "./vector";
import { RADIANS } from "./kinematics";

export interface Viewpoint {
  centreMm: Vec3;
  distanceMm: number;
  /** Round the vertical: 0 looks from the front of the arm at it, 90 from its left side. */
  azimuthDeg: number;
  /** Above the floor: 90 looks straight down. */
  elevationDeg: number;
}

export interface Size {
  width: number;
  height: number;
}

/** From top to bottom. Narrow, as from some steps away: parts near the eye are not blown up. */
export const FIELD_DEG = 32;
const NEAREST_MM = 500;
const FARTHEST_MM = 6000;
const LOWEST_DEG = -8;
/** Not quite from above, where left and right of the picture would be lost. */
const HIGHEST_DEG = 89.9;

export const VIEWS = {
  oblique: { azimuthDeg: -38, elevationDeg: 20 },
  front: { azimuthDeg: 0, elevationDeg: 6 },
  side: { azimuthDeg: -90, elevationDeg: 6 },
  top: { azimuthDeg: -90, elevationDeg: HIGHEST_DEG },
} as const;

export type ViewName = keyof typeof VIEWS;

export function turned(view: Viewpoint, azimuthDeg: number, elevationDeg: number): Viewpoint {
  const elevation = view.elevationDeg + elevationDeg;
  return {
    ...view,
    azimuthDeg: view.azimuthDeg + azimuthDeg,
    elevationDeg: Math.min(HIGHEST_DEG, Math.max(LOWEST_DEG, elevation)),
  };
}

export function nearer(view: Viewpoint, factor: number): Viewpoint {
  const distanceMm = Math.min(FARTHEST_MM, Math.max(NEAREST_MM, view.distanceMm / factor));
  return { ...view, distanceMm };
}

/** The same place seen from another side, the short way round. */
export function from(view: Viewpoint, name: ViewName): Viewpoint {
  const wanted = VIEWS[name];
  const round = Math.round((view.azimuthDeg - wanted.azimuthDeg) / 360) * 360;
  return { ...view, ...wanted, azimuthDeg: wanted.azimuthDeg + round };
}

/** Part of the way from one viewpoint to another, for a turn that the eye can follow. */
export function blend(a: Viewpoint, b: Viewpoint, share: number): Viewpoint {
  const mix = (from: number, to: number) => from + share * (to - from);
  return {
    centreMm: add(a.centreMm, scale(subtract(b.centreMm, a.centreMm), share)),
    distanceMm: mix(a.distanceMm, b.distanceMm),
    azimuthDeg: mix(a.azimuthDeg, b.azimuthDeg),
    elevationDeg: mix(a.elevationDeg, b.elevationDeg),
  };
}

/** The arm is thicker than its middle line. */
const ROOM_MM = 105;

/** The nearest viewpoint of this direction from which all these places are in the picture. */
export function overview(places: readonly Vec3[], size: Size, name: ViewName): Viewpoint {
  const { right, up, ahead } = eye({ centreMm: [0, 0, 0], distanceMm: 0, ...VIEWS[name] });
  const middle = (axis: Vec3) => {
    const along = places.map((place) => dot(place, axis));
    return scale(axis, (Math.min(...along) + Math.max(...along)) / 2);
  };
  const centreMm = add(add(middle(right), middle(up)), middle(ahead));
  const tall = Math.tan((FIELD_DEG / 2) * RADIANS);
  const wide = (tall * size.width) / size.height;
  const needed = places.map((place) => {
    const from = subtract(place, centreMm);
    const across = (Math.abs(dot(from, right)) + ROOM_MM) / wide;
    const high = (Math.abs(dot(from, up)) + ROOM_MM) / tall;
    return Math.max(across, high) - dot(from, ahead);
  });
  return { centreMm, distanceMm: Math.max(NEAREST_MM, ...needed), ...VIEWS[name] };
}

interface Eye {
  placeMm: Vec3;
  right: Vec3;
  up: Vec3;
  /** Into the picture. */
  ahead: Vec3;
}

export function eye(view: Viewpoint): Eye {
  const [azimuth, elevation] = [view.azimuthDeg * RADIANS, view.elevationDeg * RADIANS];
  const flat = Math.cos(elevation);
  const out: Vec3 = [Math.cos(azimuth) * flat, Math.sin(azimuth) * flat, Math.sin(elevation)];
  const ahead = scale(out, -1);
  const right = unit(cross(ahead, [0, 0, 1]));
  const placeMm = add(view.centreMm, scale(out, view.distanceMm));
  return { placeMm, right, up: cross(right, ahead), ahead };
}

/** How long something one pixel high is at a depth in front of the eye. */
function mmPerPixel(depthMm: number, size: Size): number {
  return (2 * Math.tan((FIELD_DEG / 2) * RADIANS) * depthMm) / size.height;
}

/** Where a place is in the picture, and how much of the world a pixel is there. */
export function onScreen(view: Viewpoint, size: Size, placeMm: Vec3) {
  const { placeMm: from, right, up, ahead } = eye(view);
  const to = subtract(placeMm, from);
  const scaleMm = mmPerPixel(Math.max(1, dot(to, ahead)), size);
  return {
    x: size.width / 2 + dot(to, right) / scaleMm,
    y: size.height / 2 - dot(to, up) / scaleMm,
    mmPerPixel: scaleMm,
  };
}

/** The place under a pixel in the plane that faces the eye and goes through `throughMm`. */
export function underFinger(view: Viewpoint, size: Size, x: number, y: number, throughMm: Vec3) {
  const { placeMm: from, right, up, ahead } = eye(view);
  const depth = Math.max(1, dot(subtract(throughMm, from), ahead));
  const perPixel = mmPerPixel(depth, size);
  const across = add(
    scale(right, (x - size.width / 2) * perPixel),
    scale(up, (size.height / 2 - y) * perPixel),
  );
  return add(add(from, scale(ahead, depth)), across);
}

export type Way = "up" | "down" | "left" | "right" | "forward" | "back";

/** A way as whoever looks at the picture means it: level ways stay level, away is away. */
export function directionOf(view: Viewpoint, way: Way): Vec3 {
  const { right, ahead, up } = eye(view);
  const level: Vec3 = [ahead[0] + up[0], ahead[1] + up[1], 0];
  const away = length(level) > 1e-6 ? unit(level) : ahead;
  const ways: Record<Way, Vec3> = {
    up: [0, 0, 1],
    down: [0, 0, -1],
    right,
    left: scale(right, -1),
    forward: away,
    back: scale(away, -1),
  };
  return ways[way];
}
