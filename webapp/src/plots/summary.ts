// A plot in words and numbers, for those who cannot see it and those who want it exact.
import { degrees, duration } from "../format/numbers";
import { t } from "../texts";

export interface JointSummary {
  start: number;
  end: number;
  lowest: number;
  highest: number;
}

export function summarise(values: readonly number[]): JointSummary | null {
  const start = values[0];
  const end = values.at(-1);
  if (start === undefined || end === undefined) return null;
  let [lowest, highest] = [start, start];
  for (const value of values) {
    if (value < lowest) lowest = value;
    if (value > highest) highest = value;
  }
  return { start, end, lowest, highest };
}

/** One sentence about a set of joint curves. */
export function sentence(
  title: string,
  timesS: readonly number[],
  joints: readonly number[][],
): string {
  const travels = joints.map((values) => {
    const summary = summarise(values);
    return summary ? summary.highest - summary.lowest : 0;
  });
  const most = Math.max(...travels);
  if (timesS.length === 0 || !Number.isFinite(most)) return `${title}: ${t.plot.empty}`;
  const length = duration((timesS.at(-1) ?? 0) - (timesS[0] ?? 0));
  return t.plot.summary(title, length, travels.indexOf(most) + 1, degrees(most));
}

/** The range a plot shows: all values with some air, and never so narrow that noise looks large. */
export function paddedRange(lowest: number, highest: number, narrowest = 4): [number, number] {
  const middle = (lowest + highest) / 2;
  const half = Math.max((highest - lowest) * 0.55, narrowest / 2);
  return [middle - half, middle + half];
}
