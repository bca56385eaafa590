// The numbers along the axes of a drawing, written as everywhere else in the app.
import { fixed } from "../format/numbers";
import { t } from "../texts";

/** As many decimals as the step between two numbers needs, and no more. */
export function axisLabels(at: readonly number[], step: number): string[] {
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  // A step such as 0.25 has more digits than its size alone tells.
  const fits = Number.isInteger(Number((step * 10 ** decimals).toFixed(6)));
  return at.map((value) => fixed(value, fits ? decimals : decimals + 1));
}

/** What the drawing asks for: the plot, places, axis, room and step. */
export const axisNumbers = (
  _plot: unknown,
  at: number[],
  _axis: number,
  _space: number,
  step: number,
): string[] => axisLabels(at, step);

export const axisSeconds = (...asked: Parameters<typeof axisNumbers>): string[] =>
  axisNumbers(...asked).map((value) => t.units.seconds(value));
