// A whole take as a small picture for the list: six lines without numbers.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { getTrajectory } from "../api/endpoints";
import { sparklinePaths } from "./sparkline-paths";

const WIDTH = 96;
const HEIGHT = 48;

/** Recorded takes never change, so a picture once made is kept while the app is open. */
const known = new Map<string, string[]>();

export function TakeSparkline({ take }: { take: string }) {
  const paths = useSignal<string[]>(known.get(take) ?? []);
  useEffect(() => {
    if (known.has(take)) return;
    getTrajectory(take, 40).then(
      (trajectory) => {
        const made = sparklinePaths(trajectory.t_s, trajectory.joints_deg, WIDTH, HEIGHT);
        known.set(take, made);
        paths.value = made;
      },
      // The list is complete without the picture; the take's own page says what is wrong.
      () => undefined,
    );
  }, [take]);
  return (
    <svg class="sparkline" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      {paths.value.map((path, joint) => (
        <path key={joint} d={path} class={`line-joint-${joint + 1}`} />
      ))}
    </svg>
  );
}
