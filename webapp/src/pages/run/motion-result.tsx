// What the arm really did: in a sentence, in figures from its feedback, and drawn over the plan.
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { getReproductionTrajectory } from "../../api/endpoints";
import type { Reproduction, ReproductionTrajectory } from "../../api/types";
import { Figures } from "../../components/figures";
import { LoadNotice, Notice, ProblemNotice } from "../../components/notice";
import { SignalTimes } from "../../components/signal-times";
import { errorDegrees, duration, fixed } from "../../format/numbers";
import { JointPanels, type Layer } from "../../plots/joint-panels";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";

export function MotionResult({ motion }: { motion: Reproduction }) {
  const trajectory = useSignal<ReproductionTrajectory | null>(null);
  const load = useLoad(async () => {
    trajectory.value = await getReproductionTrajectory(motion.id, 400);
  }, motion.id);
  const shown = trajectory.value;
  const layers = useMemo<Layer[]>(
    () =>
      shown
        ? [
            { label: t.run.measured, joints: shown.measured_deg, look: "strong" },
            { label: t.run.planned, joints: shown.commanded_deg, look: "dashed" },
          ]
        : [],
    [shown],
  );
  return (
    <>
      <Verdict motion={motion} />
      <MotionFigures motion={motion} />
      <LoadNotice load={load} empty={shown === null} />
      {shown && shown.t_s.length > 0 && (
        <>
          <JointPanels
            title={t.run.measuredPlot}
            timesS={shown.t_s}
            layers={layers}
            signalsS={shown.signals.map((signal) => signal.at_s)}
          />
          <SignalTimes title={t.signals.done} marks={shown.signals} />
        </>
      )}
    </>
  );
}

function Verdict({ motion }: { motion: Reproduction }) {
  if (motion.state === "succeeded") {
    return (
      <Notice tone="good" icon="check">
        <p>{t.run.succeeded}</p>
      </Notice>
    );
  }
  const failed = motion.state === "failed";
  const detail = motion.reason ?? (failed ? t.run.failed : t.run.stopped);
  const advice = failed ? t.run.failedAdvice : t.run.stoppedAdvice;
  if (failed) return <ProblemNotice title={t.run.failed} problem={{ detail, advice }} />;
  return (
    <Notice tone="soft" icon="stop" title={t.run.stopped}>
      {motion.reason && <p>{motion.reason}</p>}
      <p>{advice}</p>
    </Notice>
  );
}

function MotionFigures({ motion }: { motion: Reproduction }) {
  const names = t.run.figures;
  const tracking = motion.tracking_error_deg;
  return (
    <Figures
      list={[
        [names.e_j, show(motion.e_j_deg, (value) => errorDegrees(value, 3))],
        [names.gmcc, show(motion.gmcc, (value) => fixed(value, 4))],
        [names.trackingMean, show(tracking?.mean, (value) => errorDegrees(value, 2))],
        [names.trackingMax, show(tracking?.max, (value) => errorDegrees(value, 2))],
        [names.e_jCommanded, show(motion.e_j_commanded_deg, (value) => errorDegrees(value, 3))],
        [names.duration, duration(motion.duration_s)],
      ]}
    />
  );
}

function show(value: number | null | undefined, words: (value: number) => string): string | null {
  return value === null || value === undefined ? null : words(value);
}
