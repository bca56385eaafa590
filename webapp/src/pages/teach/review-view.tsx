// A finished take: its state, its plot and its figures.
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { getWholeTrajectory } from "../../api/endpoints";
import type { Demonstration, SignalMark, Trajectory, Trim } from "../../api/types";
import { TakePicture } from "../../arm3d/take-picture";
import { Figures } from "../../components/figures";
import { LoadNotice, Notice } from "../../components/notice";
import { SignalTimes } from "../../components/signal-times";
import { duration, fixed } from "../../format/numbers";
import { JointPanels, type Layer } from "../../plots/joint-panels";
import { counts, type Compared } from "../../state/agreement";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";
import { usedS } from "./take-list";
import { TakesAdvice } from "./takes-advice";
import { TrimEditor, usedOf } from "./trim-editor";

export function ReviewView({ take, compared }: { take: Demonstration; compared: Compared }) {
  const trajectory = useSignal<Trajectory | null>(null);
  const load = useLoad(async () => {
    trajectory.value = await getWholeTrajectory(take.id, 300);
  }, take.id);
  /** What is used of the take, or would be once it is saved. */
  const span = useSignal<Trim>(usedOf(take));
  const time = useSignal(0);
  const shown = trajectory.value;
  const layers = useMemo<Layer[]>(
    () => (shown ? [{ label: t.plot.degrees, joints: shown.joints_deg, look: "strong" }] : []),
    [shown],
  );
  return (
    <>
      <StateNotice take={take} />
      {shown && shown.t_s.length > 1 && <TakePicture take={shown} time={time} />}
      {counts(take) && <TakesAdvice compared={compared} />}
      {take.problem && (
        <Notice tone="bad" icon="alert">
          <p>{take.problem}</p>
        </Notice>
      )}
      {take.note && take.state !== "interrupted" && (
        <Notice tone="plain" icon="info">
          <p>{take.note}</p>
        </Notice>
      )}
      <LoadNotice load={load} empty={shown === null} />
      {shown && (
        <>
          <TrimEditor take={take} trajectory={shown} span={span} />
          <JointPanels
            title={t.teach.tracePlot}
            timesS={shown.t_s}
            layers={layers}
            cut={span}
            signalsS={shown.signals.filter(isChange).map((signal) => signal.at_s)}
            cursor={time}
          />
          <SignalTimes title={t.signals.recorded} marks={shown.signals.filter(isChange)} />
        </>
      )}
      <Figures
        list={[
          [t.teach.figures.duration, duration(take.duration_s)],
          [t.teaching.trim.used, take.trim ? duration(usedS(take)) : null],
          [t.teach.figures.source, t.teach.sources[take.source]],
          [t.teach.figures.samples, String(take.samples)],
          [t.teach.figures.rate, fixed(take.rate_hz, 0)],
          [t.teach.figures.gaps, String(take.gaps)],
          [t.teaching.pause.count, take.pauses ? String(take.pauses) : null],
        ]}
      />
    </>
  );
}

/** At 0 it is only said how a signal stood at the beginning. */
const isChange = (mark: SignalMark) => mark.at_s > 0;

function StateNotice({ take }: { take: Demonstration }) {
  switch (take.state) {
    case "interrupted":
      return (
        <Notice tone="soft" icon="alert" title={t.teach.states.interrupted}>
          <p>{t.teach.interruptedExplain}</p>
          {take.note && <p>{take.note}</p>}
        </Notice>
      );
    case "kept":
      return (
        <Notice tone="good" icon="check">
          <p>{t.teach.isKept}</p>
        </Notice>
      );
    case "discarded":
      return (
        <Notice tone="plain" icon="bin">
          <p>{t.teach.isDiscarded}</p>
        </Notice>
      );
    default:
      return <p class="question">{t.teach.reviewAsk}</p>;
  }
}
