// A whole take as a small picture for the list: six lines without numbers.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { getTrajectory } from "../api/endpoints";
import type { Trim } from "../api/types";
import { sparklinePaths } from "./sparkline-paths";

const WIDTH = 96;
const HEIGHT = 48;

/** Recorded takes never change, only what is cut of them: a picture once made is kept while the app
 *  is open. */
const known = new Map<string, string[]>();

export function TakeSparkline({ take, trim }: { take: string; trim?: Trim | null | undefined }) {
  const key = `${take} ${trim?.from_s} ${trim?.to_s}`;
  const paths = useSignal<string[]>(known.get(key) ?? []);
  useEffect(() => {
    paths.value = known.get(key) ?? [];
    if (known.has(key)) return;
    getTrajectory(take, 40).then(
      (trajectory) => {
        const made = sparklinePaths(trajectory.t_s, trajectory.joints_deg, WIDTH, HEIGHT);
        known.set(key, made);
        paths.value = made;
      },
      // The list is complete without the picture; the take's own page says what is wrong.
      () => undefined,
    );
  }, [key]);
  return (
    <svg class="sparkline" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      {paths.value.map((path, joint) => (
        <path key={joint} d={path} class={`line-joint-${joint + 1}`} />
      ))}
    </svg>
  );
}
