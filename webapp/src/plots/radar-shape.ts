// The mathematics of the radar plot: answers from 1 to 5 on axes that leave one centre.

/** The centre stands for nought, so that the lowest answer still has a shape. */
export const HIGHEST = 5;

export interface Point {
  x: number;
  y: number;
}

/** Where `share` of an axis' length ends. The first axis points up, the others follow clockwise. */
export function onAxis(
  axis: number,
  axes: number,
  share: number,
  centre: Point,
  radius: number,
): Point {
  const turn = (2 * Math.PI * axis) / axes;
  return {
    x: centre.x + radius * share * Math.sin(turn),
    y: centre.y - radius * share * Math.cos(turn),
  };
}

/** The closed outline through one value on each axis, as an SVG path. */
export function outline(values: readonly number[], centre: Point, radius: number): string {
  const points = values.map((value, axis) => {
    const share = Math.min(HIGHEST, Math.max(0, value)) / HIGHEST;
    const { x, y } = onAxis(axis, values.length, share, centre, radius);
    return `${x.toFixed(1)} ${y.toFixed(1)}`;
  });
  return points.length > 0 ? `M${points.join("L")}Z` : "";
}

export interface Extremes {
  best: number;
  worst: number;
  /** There is no difference that the shown decimal would show. */
  even: boolean;
}

/** Which axes have the highest and the lowest value; of equal ones, the first. */
export function extremes(values: readonly number[]): Extremes | null {
  if (values.length === 0) return null;
  const best = values.indexOf(Math.max(...values));
  const worst = values.indexOf(Math.min(...values));
  const shown = (axis: number) => (values[axis] ?? 0).toFixed(1);
  return { best, worst, even: shown(best) === shown(worst) };
}
