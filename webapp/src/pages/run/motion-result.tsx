// What the arm really did: in a sentence, in figures from its feedback, and drawn over the plan.
import type { Reproduction } from "../../api/types";
import { Figures } from "../../components/figures";
import { Notice, ProblemNotice } from "../../components/notice";
import { errorDegrees, duration, fixed } from "../../format/numbers";
import { t } from "../../texts";
import { FlightRecord } from "./flight";
import { QuestionnaireInvite } from "./invite";
import { OutcomeQuestion } from "./outcome";

export function MotionResult({ motion }: { motion: Reproduction }) {
  return (
    <>
      <Verdict motion={motion} />
      <OutcomeQuestion motion={motion} />
      <QuestionnaireInvite motion={motion} />
      <MotionFigures motion={motion} />
      <ByJoint motion={motion} />
      <FlightRecord motion={motion} />
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
  const counts = motion.cycles;
  return (
    <Figures
      list={[
        [names.e_j, show(motion.e_j_deg, (value) => errorDegrees(value, 3))],
        [names.gmcc, show(motion.gmcc, (value) => fixed(value, 4))],
        [names.trackingMean, show(tracking?.mean, (value) => errorDegrees(value, 2))],
        [names.trackingMax, show(tracking?.max, (value) => errorDegrees(value, 2))],
        [names.e_jCommanded, show(motion.e_j_commanded_deg, (value) => errorDegrees(value, 3))],
        [names.duration, duration(motion.duration_s)],
        [t.flight.counts.cycles, counts ? String(counts.total) : null],
        [t.flight.counts.lost, counts ? String(counts.lost) : null],
        [t.flight.counts.late, counts ? String(counts.late) : null],
        [t.flight.counts.held, unusual(counts?.held)],
        [t.flight.counts.limited, unusual(counts?.limited)],
      ]}
    />
  );
}

function ByJoint({ motion }: { motion: Reproduction }) {
  const { max_by_joint: most, rms_by_joint: rms } = motion.tracking_error_deg ?? {};
  if (!most || !rms) return null;
  return (
    <details class="numbers">
      <summary>{t.flight.byJoint}</summary>
      <table aria-label={t.flight.byJoint}>
        <thead>
          <tr>
            <td />
            <th scope="col">{t.flight.most}</th>
            <th scope="col">{t.flight.rms}</th>
          </tr>
        </thead>
        <tbody>
          {most.map((worst, joint) => (
            <tr key={joint}>
              <th scope="row" aria-label={t.plot.joint(joint + 1)}>
                {t.plot.short(joint + 1)}
              </th>
              <td>{errorDegrees(worst, 2)}</td>
              <td>{errorDegrees(rms[joint] ?? 0, 3)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}

/** Cycles that are as they should be are not worth a line. */
function unusual(count: number | undefined): string | null {
  return count ? String(count) : null;
}

function show(value: number | null | undefined, words: (value: number) => string): string | null {
  return value === null || value === undefined ? null : words(value);
}
