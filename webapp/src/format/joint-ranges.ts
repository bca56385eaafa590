// The working ranges of the arm's joints, to catch a slip of the finger before it is sent.
// The server checks again and has the last word.
import { parseDecimal } from "./numbers";

export interface Range {
  lowest: number;
  highest: number;
}

/** GoFa CRB 15000-5/0.95, from ABB's product manual. */
export const JOINT_RANGES_DEG: readonly Range[] = [
  { lowest: -180, highest: 180 },
  { lowest: -180, highest: 180 },
  { lowest: -225, highest: 85 },
  { lowest: -180, highest: 180 },
  { lowest: -180, highest: 180 },
  { lowest: -270, highest: 270 },
];

export type Verdict = "ok" | "not_number" | "out_of_range";

export function checkJoint(joint: number, text: string): Verdict {
  const value = parseDecimal(text);
  const range = JOINT_RANGES_DEG[joint];
  if (value === null || range === undefined) return "not_number";
  return value >= range.lowest && value <= range.highest ? "ok" : "out_of_range";
}

/** Six typed texts as joint angles; null unless all are numbers within range. */
export function readJoints(texts: readonly string[]): number[] | null {
  if (texts.length !== JOINT_RANGES_DEG.length) return null;
  if (texts.some((text, joint) => checkJoint(joint, text) !== "ok")) return null;
  return texts.map((text) => parseDecimal(text) ?? 0);
}
