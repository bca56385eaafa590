// What has to be in a picture from the beginning.
import { centreLineMm } from "./kinematics";
import type { Pose } from "./poses";
import type { Vec3 } from "./vector";

/** Everywhere that the arm is during a motion. */
export function roomOf(poses: readonly Pose[]): Vec3[] {
  return poses.flatMap((pose) => centreLineMm(pose));
}

/** Where an arm that is led by hand mostly goes: the picture need not follow it. */
export const WORKPLACE_MM: readonly Vec3[] = [
  [-150, -350, 0],
  [650, -350, 100],
  [650, 350, 100],
  [0, 0, 850],
];
