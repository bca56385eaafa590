// A tube along a path, with a radius of its own at each point: the path itself, and its spread.
import { add, cross, dot, length, scale, subtract, unit, type Vec3 } from "./vector";

export interface Tube {
  positions: Float32Array;
  normals: Float32Array;
  indices: number[];
}

/** Points that hardly differ from the one before them are left out: a standing arm has no
 *  direction. */
export function apart<T>(points: readonly T[], placeMm: (point: T) => Vec3, leastMm: number): T[] {
  const kept: T[] = [];
  for (const point of points) {
    const last = kept.at(-1);
    if (last === undefined || length(subtract(placeMm(point), placeMm(last))) >= leastMm) {
      kept.push(point);
    }
  }
  return kept;
}

/** Rings around the path, closed by a point at each end. The rings do not twist: each ring's first
 *  direction is the one before it, made square to the path again. */
export function tube(path: readonly Vec3[], radiusMm: (point: number) => number, sides: number) {
  const rings = path.length;
  const positions: number[] = [];
  const normals: number[] = [];
  let across: Vec3 = [0, 0, 0];
  path.forEach((centre, point) => {
    const before = path[Math.max(0, point - 1)]!;
    const after = path[Math.min(rings - 1, point + 1)]!;
    const along = unit(subtract(after, before));
    across = square(across, along);
    const other = cross(along, across);
    for (let side = 0; side < sides; side += 1) {
      const angle = (2 * Math.PI * side) / sides;
      const out = add(scale(across, Math.cos(angle)), scale(other, Math.sin(angle)));
      positions.push(...add(centre, scale(out, radiusMm(point))));
      normals.push(...out);
    }
  });
  const indices: number[] = [];
  for (let ring = 0; ring + 1 < rings; ring += 1) {
    for (let side = 0; side < sides; side += 1) {
      const [a, b] = [ring * sides + side, ring * sides + ((side + 1) % sides)];
      indices.push(a, b, a + sides, b, b + sides, a + sides);
    }
  }
  for (const [ring, first] of [
    [0, true],
    [rings - 1, false],
  ] as const) {
    const [end, other] = [path[ring]!, path[first ? 1 : rings - 2]!];
    const out = unit(subtract(end, other));
    const middle = positions.length / 3;
    positions.push(...end);
    normals.push(...out);
    for (let side = 0; side < sides; side += 1) {
      const [a, b] = [ring * sides + side, ring * sides + ((side + 1) % sides)];
      indices.push(...(first ? [middle, b, a] : [middle, a, b]));
    }
  }
  const made: Tube = {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    indices,
  };
  return made;
}

function square(across: Vec3, along: Vec3): Vec3 {
  const rest = subtract(across, scale(along, dot(across, along)));
  if (length(rest) > 1e-6) return unit(rest);
  const upright: Vec3 = Math.abs(along[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  return unit(cross(along, upright));
}
