// What the lines and the translucent arm in a picture mean.
import { t } from "../texts";

export type Shown = keyof typeof t.arm3d.legend;

const LOOKS: Record<Shown, string> = {
  path: "path",
  approach: "quiet",
  planned: "quiet",
  band: "band",
  ghostGoal: "ghost",
  ghostPlanned: "ghost",
};

export function PictureLegend({ shown }: { shown: readonly Shown[] }) {
  return (
    <p class="legend">
      {shown.map((what) => (
        <span key={what}>
          <i class={`legend-line legend-${LOOKS[what]}`} aria-hidden="true" />
          {t.arm3d.legend[what]}
        </span>
      ))}
    </p>
  );
}
