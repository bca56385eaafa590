// Smooth rounded bodies as triangles: what the arm is built from. Millimetres.
import type { Vec3 } from "./vector";

export interface Solid {
  positions: number[];
  normals: number[];
  indices: number[];
}

const CORNER_STEPS = 3;
const AROUND = 32;

/** A corner of an outline: distance from the axis, height along it, and how far it is rounded. */
export type Corner = readonly [radius: number, height: number, round?: number];

interface Edge {
  radius: number;
  height: number;
  /** The outward normal in the plane of the outline. */
  out: readonly [number, number];
}

/** A body turned about z from an outline that goes from its bottom to its top. */
export function lathe(outline: readonly Corner[]): Solid {
  const edges = roundedOutline(outline);
  const solid: Solid = { positions: [], normals: [], indices: [] };
  edges.forEach(({ radius, height, out }, row) => {
    for (let step = 0; step < AROUND; step += 1) {
      const angle = (2 * Math.PI * step) / AROUND;
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      solid.positions.push(radius * cos, radius * sin, height);
      solid.normals.push(out[0] * cos, out[0] * sin, out[1]);
    }
    if (row > 0) joinRings(solid, (row - 1) * AROUND, row * AROUND, AROUND);
  });
  return solid;
}

/** A cylinder with rounded edges about z. */
export function barrel(radius: number, bottom: number, top: number, round: number): Solid {
  return lathe([
    [0, bottom],
    [radius, bottom, round],
    [radius, top, round],
    [0, top],
  ]);
}

/** The outline with its corners rounded, and a normal at each of its points. */
function roundedOutline(corners: readonly Corner[]): Edge[] {
  const edges: Edge[] = [];
  corners.forEach(([radius, height, round = 0], at) => {
    const before = corners[at - 1];
    const after = corners[at + 1];
    const coming = before && direction(before, [radius, height]);
    const going = after && direction([radius, height], after);
    const [first, last] = [coming ?? going!, going ?? coming!];
    const [a, b] = [rightOf(first), rightOf(last)];
    if (!coming || !going) {
      edges.push({ radius, height, out: a });
      return;
    }
    const turn = Math.atan2(first[0] * last[1] - first[1] * last[0], dot2(first, last));
    const cut = round * Math.tan(Math.abs(turn) / 2);
    const bent = Math.sign(turn) * round;
    const centre = [
      radius - first[0] * cut - a[0] * bent,
      height - first[1] * cut - a[1] * bent,
    ] as const;
    for (let step = 0; step <= CORNER_STEPS; step += 1) {
      const by = (turn * step) / CORNER_STEPS;
      const out = turn2(a, by);
      const place = { radius: centre[0] + out[0] * bent, height: centre[1] + out[1] * bent };
      edges.push({ ...place, out: step === CORNER_STEPS ? b : out });
    }
  });
  return edges;
}

type Vec2 = readonly [number, number];
const dot2 = (a: Vec2, b: Vec2) => a[0] * b[0] + a[1] * b[1];
const rightOf = (a: Vec2): Vec2 => [a[1], -a[0]];
const turn2 = (a: Vec2, by: number): Vec2 => [
  a[0] * Math.cos(by) - a[1] * Math.sin(by),
  a[0] * Math.sin(by) + a[1] * Math.cos(by),
];

function direction(from: Corner, to: Corner): Vec2 {
  const [r, h] = [to[0] - from[0], to[1] - from[1]];
  const size = Math.hypot(r, h);
  return [r / size, h / size];
}

/** A flat link with round ends of two radii, from the origin along x, `thick` along z about the
 *  origin, its edges rounded. */
export function link(
  startRadius: number,
  endRadius: number,
  long: number,
  thick: number,
  round: number,
) {
  const solid: Solid = { positions: [], normals: [], indices: [] };
  const outline = linkOutline(startRadius, endRadius, long);
  const count = outline.length;
  const steps = CORNER_STEPS * 2;
  const half = thick / 2;
  // Down one rounded edge and up the other: rings from the upper face to the lower.
  for (let row = 0; row <= 2 * steps + 1; row += 1) {
    const lower = row > steps;
    const angle = (Math.PI / 2) * ((lower ? row - 1 : row) / steps);
    const [side, up] = [Math.sin(angle), Math.cos(angle)];
    const height = up * round + (lower ? round - half : half - round);
    for (const { at, out } of outline) {
      const inset = round * (1 - side);
      solid.positions.push(at[0] - out[0] * inset, at[1] - out[1] * inset, height);
      solid.normals.push(out[0] * side, out[1] * side, up);
    }
    if (row > 0) joinRings(solid, row * count, (row - 1) * count, count);
  }
  cap(solid, 0, count, [long / 2, 0, half], [0, 0, 1]);
  cap(solid, (2 * steps + 1) * count, count, [long / 2, 0, -half], [0, 0, -1]);
  return solid;
}

/** Two circles and the lines that touch both, anticlockwise. */
function linkOutline(startRadius: number, endRadius: number, long: number) {
  const lean = long > 0 ? Math.asin((startRadius - endRadius) / long) : 0;
  const outline: { at: Vec2; out: Vec2 }[] = [];
  const half = AROUND / 2;
  const arc = (centre: number, radius: number, from: number, to: number) => {
    for (let step = 0; step <= half; step += 1) {
      const angle = from + ((to - from) * step) / half;
      const out: Vec2 = [Math.cos(angle), Math.sin(angle)];
      outline.push({ at: [centre + radius * out[0], radius * out[1]], out });
    }
  };
  const touch = Math.PI / 2 - lean;
  arc(long, endRadius, -touch, touch);
  arc(0, startRadius, touch, 2 * Math.PI - touch);
  return outline;
}

function joinRings(solid: Solid, lower: number, upper: number, count: number): void {
  for (let step = 0; step < count; step += 1) {
    const next = (step + 1) % count;
    solid.indices.push(lower + step, lower + next, upper + step);
    solid.indices.push(lower + next, upper + next, upper + step);
  }
}

function cap(solid: Solid, ring: number, count: number, middle: Vec3, out: Vec3): void {
  const first = solid.positions.length / 3;
  solid.positions.push(...middle, ...solid.positions.slice(ring * 3, (ring + count) * 3));
  for (let step = 0; step <= count; step += 1) solid.normals.push(...out);
  for (let step = 0; step < count; step += 1) {
    const [a, b] = [first + 1 + step, first + 1 + ((step + 1) % count)];
    solid.indices.push(...(out[2] > 0 ? [first, a, b] : [first, b, a]));
  }
}

/** Which way a body made about z lies in its link. A flat link made along x and flat in z then
 *  goes up along z, flat in y; or stays along x, flat in y. */
export type Lie = "about z" | "about y" | "about x" | "along x, flat in y";

const LIES: Record<Lie, (v: Vec3) => Vec3> = {
  "about z": (v) => v,
  "about y": ([x, y, z]) => [y, z, x],
  "about x": ([x, y, z]) => [z, x, y],
  "along x, flat in y": ([x, y, z]) => [x, z, -y],
};

/** The body laid so, and then moved. */
export function laid(solid: Solid, lie: Lie, at: Vec3 = [0, 0, 0]): Solid {
  const each = (list: readonly number[], change: (v: Vec3) => Vec3) =>
    Array.from({ length: list.length / 3 }, (_, vertex) => {
      const v: Vec3 = [list[vertex * 3]!, list[vertex * 3 + 1]!, list[vertex * 3 + 2]!];
      return change(v);
    }).flat();
  return {
    positions: each(solid.positions, (v) => {
      const [x, y, z] = LIES[lie](v);
      return [x + at[0], y + at[1], z + at[2]];
    }),
    normals: each(solid.normals, LIES[lie]),
    indices: solid.indices,
  };
}

/** Several bodies as one, to be drawn at once. */
export function together(solids: readonly Solid[]): Solid {
  const one: Solid = { positions: [], normals: [], indices: [] };
  for (const solid of solids) {
    const first = one.positions.length / 3;
    for (const value of solid.positions) one.positions.push(value);
    for (const value of solid.normals) one.normals.push(value);
    for (const index of solid.indices) one.indices.push(first + index);
  }
  return one;
}
