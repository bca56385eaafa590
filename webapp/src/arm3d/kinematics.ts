// Where the arm's parts are for given joint angles: the chain of the CRB 15000-5/0.95, the same as
// in the server's motion crate. Millimetres and degrees come in and go out.
import { add, cross, subtract, turnAbout, type Vec3 } from "./vector";

/** Origin of each joint in the frame of the part before it, and the axis it turns about. All
 *  frames are parallel when every joint is at zero. */
export const CHAIN: readonly { offsetMm: Vec3; axis: Vec3 }[] = [
  { offsetMm: [0, 0, 265], axis: [0, 0, 1] },
  { offsetMm: [0, 0, 0], axis: [0, 1, 0] },
  { offsetMm: [0, 0, 444], axis: [0, 1, 0] },
  { offsetMm: [0, 0, 110], axis: [1, 0, 0] },
  { offsetMm: [470, 0, 0], axis: [0, 1, 0] },
  { offsetMm: [101, 0, 80], axis: [1, 0, 0] },
];

export const RADIANS = Math.PI / 180;

/** A place with three directions of length one. */
export interface Frame {
  originMm: Vec3;
  x: Vec3;
  y: Vec3;
  z: Vec3;
}

interface Chain {
  /** Joint by joint: its place and its axis in the base's frame, before it turns the next part. */
  joints: { originMm: Vec3; axis: Vec3 }[];
  end: Frame;
}

function follow(jointsDeg: readonly number[]): Chain {
  let end: Frame = { originMm: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
  const joints = CHAIN.map(({ offsetMm, axis }, joint) => {
    const originMm = add(end.originMm, inBase(end, offsetMm));
    const turned = inBase(end, axis);
    const by = (jointsDeg[joint] ?? 0) * RADIANS;
    end = {
      originMm,
      x: turnAbout(end.x, turned, by),
      y: turnAbout(end.y, turned, by),
      z: turnAbout(end.z, turned, by),
    };
    return { originMm, axis: turned };
  });
  return { joints, end };
}

function inBase(frame: Frame, v: Vec3): Vec3 {
  const part = (at: 0 | 1 | 2) => frame.x[at] * v[0] + frame.y[at] * v[1] + frame.z[at] * v[2];
  return [part(0), part(1), part(2)];
}

/** The bare flange, called tool0: its z points out of it, along x of the last link. */
export function toolFrame(jointsDeg: readonly number[]): Frame {
  const { end } = follow(jointsDeg);
  const back: Vec3 = [-end.z[0], -end.z[1], -end.z[2]];
  return { originMm: end.originMm, x: back, y: end.y, z: end.x };
}

/** The middle of the flange in the base's frame. */
export function toolMm(jointsDeg: readonly number[]): Vec3 {
  return follow(jointsDeg).end.originMm;
}

/** The base, every joint and the flange: what a picture has to have room for. */
export function centreLineMm(jointsDeg: readonly number[]): Vec3[] {
  return [[0, 0, 0], ...follow(jointsDeg).joints.map((joint) => joint.originMm)];
}

/** How the flange moves when a joint does, in millimetres for a degree: one vector each joint. */
export function toolMmPerDegree(jointsDeg: readonly number[]): Vec3[] {
  const { joints, end } = follow(jointsDeg);
  return joints.map(({ originMm, axis }) => {
    const moved = cross(axis, subtract(end.originMm, originMm));
    return [moved[0] * RADIANS, moved[1] * RADIANS, moved[2] * RADIANS];
  });
}
