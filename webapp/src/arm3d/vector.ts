// Vectors of three numbers: only what the drawing of the arm needs, without the drawing library,
// so that what is reckoned here is tested without a screen.

export type Vec3 = readonly [number, number, number];

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, by: number): Vec3 => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);

export const distance = (a: Vec3, b: Vec3): number => length(subtract(a, b));

/** The direction alone; a vector without length stays as it is. */
export const unit = (a: Vec3): Vec3 => scale(a, 1 / (length(a) || 1));

/** `a` turned by an angle about a direction of length one. */
export function turnAbout(a: Vec3, axis: Vec3, angleRad: number): Vec3 {
  const [sin, cos] = [Math.sin(angleRad), Math.cos(angleRad)];
  const along = scale(axis, dot(axis, a) * (1 - cos));
  return add(add(scale(a, cos), scale(cross(axis, a), sin)), along);
}
