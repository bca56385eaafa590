// Curves as SVG paths. Each joint is drawn about its own middle on one common scale, so that the
// picture shows how much each moves and not where it happens to stand.
import { summarise } from "./summary";

export function sparklinePaths(
  timesS: readonly number[],
  joints: readonly number[][],
  width: number,
  height: number,
): string[] {
  const first = timesS[0] ?? 0;
  const length = Math.max((timesS.at(-1) ?? 0) - first, Number.EPSILON);
  const summaries = joints.map(summarise);
  const widest = Math.max(1, ...summaries.map((one) => (one ? one.highest - one.lowest : 0)));
  const margin = 2;
  return joints.map((values, joint) => {
    const summary = summaries[joint];
    if (!summary) return "";
    const middle = (summary.lowest + summary.highest) / 2;
    const points = values.map((value, at) => {
      const x = margin + ((width - 2 * margin) * ((timesS[at] ?? first) - first)) / length;
      const y = height / 2 - ((height - 2 * margin) * (value - middle)) / widest;
      return `${x.toFixed(1)} ${y.toFixed(1)}`;
    });
    return `M${points.join("L")}`;
  });
}
