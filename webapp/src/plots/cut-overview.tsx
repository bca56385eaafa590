// A whole take as a small picture above the handles that cut it: what is cut away is veiled.
import type { ReadonlySignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type { Trajectory, Trim } from "../api/types";
import { sparklinePaths } from "./sparkline-paths";

const WIDTH = 300;
const HEIGHT = 72;

interface Props {
  trajectory: Trajectory;
  span: ReadonlySignal<Trim>;
}

export function CutOverview({ trajectory: { t_s, joints_deg }, span }: Props) {
  const paths = useMemo(() => sparklinePaths(t_s, joints_deg, WIDTH, HEIGHT), [t_s, joints_deg]);
  const lengthS = Math.max(t_s.at(-1) ?? 0, Number.EPSILON);
  const [from, to] = [span.value.from_s, span.value.to_s].map((atS) => (WIDTH * atS) / lengthS);
  return (
    <svg
      class="cut-overview"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      preserveAspectRatio="none"
      aria-hidden="true"
    >
      {paths.map((path, joint) => (
        <path key={joint} d={path} class={`line-joint-${joint + 1}`} />
      ))}
      <rect x={0} y={0} width={from} height={HEIGHT} />
      <rect x={to} y={0} width={WIDTH - (to ?? 0)} height={HEIGHT} />
    </svg>
  );
}
