// A planned motion as a picture: the arm on its way, where it ends, and how far the takes that it
// was learned from lay apart.
import type { Signal } from "@preact/signals";
import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { getCurve } from "../api/endpoints";
import type { Curve, Plan } from "../api/types";
import { ReplaySlider } from "../components/replay-slider";
import { t } from "../texts";
import { ArmView, type Band, type PathLine } from "./arm-view";
import { PictureLegend, type Shown } from "./legend";
import { between, poseAt, somePoses, type Pose, type Track } from "./poses";
import { roomOf } from "./room";

const POINTS = 160;

export function PlanPicture({ plan, time }: { plan: Plan; time: Signal<number> }) {
  const track = useMemo<Track>(() => ({ timesS: plan.t_s, jointsDeg: plan.joints_deg }), [plan]);
  const joints = useComputed(() => poseAt(track, time.value));
  const goal = useComputed<Pose | null>(() => plan.goal_deg);
  const curve = useSignal<Curve | null>(null);
  useEffect(() => {
    // The spread is an addition: without it the planned way is shown all the same.
    getCurve(plan.model_id, POINTS).then(
      (found) => (curve.value = found),
      () => undefined,
    );
  }, [plan.model_id]);
  const learned = curve.value;
  const band = useMemo(() => learned && bandOf(learned), [learned]);
  const paths = useMemo<PathLine[]>(() => {
    const startS = plan.approach_s;
    const motion = somePoses(between(track, startS, Infinity), POINTS);
    const approach = somePoses(between(track, 0, startS), POINTS);
    return [
      { look: "path", poses: motion },
      ...(startS > 0 ? [{ look: "quiet" as const, poses: approach }] : []),
    ];
  }, [track]);
  const room = useMemo(() => roomOf(somePoses(track, 24)), [track]);
  const shown: Shown[] = [
    "path",
    ...(plan.approach_s > 0 ? (["approach"] as const) : []),
    ...(band ? (["band"] as const) : []),
    "ghostGoal",
  ];
  return (
    <section class="replay">
      <ArmView
        joints={joints}
        ghost={goal}
        paths={paths}
        band={band}
        room={room}
        label={t.arm3d.labels.plan}
      >
        <ReplaySlider time={time} endS={plan.duration_s} />
      </ArmView>
      <PictureLegend shown={shown} />
    </section>
  );
}

function bandOf(curve: Curve): Band {
  const poses = somePoses({ timesS: curve.t_s, jointsDeg: curve.mean_deg }, POINTS);
  const stdDeg = somePoses({ timesS: curve.t_s, jointsDeg: curve.std_deg }, POINTS);
  return { poses, stdDeg };
}
