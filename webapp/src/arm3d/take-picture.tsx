// A recorded take as a picture, played once as soon as it is opened: the question is whether it
// was good.
import type { Signal } from "@preact/signals";
import { useComputed } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type { Trajectory } from "../api/types";
import { ReplaySlider } from "../components/replay-slider";
import { t } from "../texts";
import { ArmView, type PathLine } from "./arm-view";
import { poseAt, somePoses, type Track } from "./poses";
import { roomOf } from "./room";

const POINTS = 160;

export function TakePicture({ take, time }: { take: Trajectory; time: Signal<number> }) {
  const track = useMemo<Track>(() => ({ timesS: take.t_s, jointsDeg: take.joints_deg }), [take]);
  const joints = useComputed(() => poseAt(track, time.value));
  const paths = useMemo<PathLine[]>(
    () => [{ look: "path", poses: somePoses(track, POINTS) }],
    [track],
  );
  const room = useMemo(() => roomOf(somePoses(track, 24)), [track]);
  return (
    <ArmView joints={joints} paths={paths} room={room} label={t.arm3d.labels.take}>
      <ReplaySlider time={time} endS={take.t_s.at(-1) ?? 0} playAtOnce />
    </ArmView>
  );
}
