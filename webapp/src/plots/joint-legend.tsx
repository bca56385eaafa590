// Six joints in one drawing: told apart by colour and by the pattern of their lines.
import type uPlot from "uplot";
import { t } from "../texts";
import { colour } from "./colours";

const JOINT_DASHES: number[][] = [[], [8, 4], [2, 3], [], [8, 4], [2, 3]];

export function JointLegend() {
  return (
    <p class="legend">
      {JOINT_DASHES.map((_, joint) => (
        <span key={joint}>
          <i class={`legend-line legend-joint-${joint + 1}`} aria-hidden="true" />
          {t.plot.short(joint + 1)}
        </span>
      ))}
    </p>
  );
}

/** The line of each joint, after the times. */
export function jointSeries(): uPlot.Series[] {
  const lines = JOINT_DASHES.map((dash, joint) => ({
    stroke: colour(`joint-${joint + 1}`),
    width: 2,
    dash,
    points: { show: false },
  }));
  return [{}, ...lines];
}
