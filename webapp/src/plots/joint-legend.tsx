// Six joints in one drawing: told apart by colour and by the pattern of their lines.
import { t } from "../texts";

export const JOINT_DASHES: number[][] = [[], [8, 4], [2, 3], [], [8, 4], [2, 3]];

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
