// The target of a tool that is led by a button: it goes ahead of the tool at a walking pace, but
// never far, so that nothing is left to catch up when the button is let go.
import type { Frame } from "./kinematics";
import { add, distance, dot, scale, subtract, unit, type Vec3 } from "./vector";

export const PACE_MM_S = 120;
export const TURN_DEG_S = 30;
const LEASH_MM = 60;

export interface Steered {
  toolMm: Vec3;
  turnDeg: Vec3;
}

export type Steer = { kind: "move"; direction: Vec3 } | { kind: "turn"; axis: Vec3 };

/** Where the tool is wanted `elapsedS` later. `taken` is the flange as it was taken, `toolMm` where
 *  it is now. */
export function steered(
  at: Steered,
  steer: Steer,
  elapsedS: number,
  taken: Frame,
  toolMm: Vec3,
): Steered {
  if (steer.kind === "turn") {
    // The axis is one of the room; the server wants it in the flange's own frame.
    const { axis } = steer;
    const own: Vec3 = [dot(taken.x, axis), dot(taken.y, axis), dot(taken.z, axis)];
    return { ...at, turnDeg: add(at.turnDeg, scale(unit(own), TURN_DEG_S * elapsedS)) };
  }
  const wanted = add(at.toolMm, scale(steer.direction, PACE_MM_S * elapsedS));
  const ahead = distance(wanted, toolMm);
  if (ahead <= LEASH_MM) return { ...at, toolMm: wanted };
  return { ...at, toolMm: add(toolMm, scale(subtract(wanted, toolMm), LEASH_MM / ahead)) };
}
