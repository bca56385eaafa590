// The planned motion before it happens: checked, drawn, and started only from here.
import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { startReproduction } from "../../api/endpoints";
import { newId } from "../../api/ids";
import type { Plan } from "../../api/types";
import { PlanPicture } from "../../arm3d/plan-picture";
import { Button, ButtonLink } from "../../components/button";
import { Figures } from "../../components/figures";
import { Notice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { SignalTimes } from "../../components/signal-times";
import { RunModeChoice } from "./run-mode-choice";
import { duration, fixed } from "../../format/numbers";
import { JointPanels, type Layer } from "../../plots/joint-panels";
import { reproductions } from "../../state/entities";
import { useAction } from "../../state/hooks";
import { connection, robot } from "../../state/live";
import { go } from "../../state/navigation";
import { whyNotReady } from "../../state/robot-status";
import { robotId } from "../../state/robots";
import { isHeld, planOf, preview } from "../../state/run-setup";
import { t } from "../../texts";

export function PreviewPage({ task }: { task: string }) {
  const plan = planOf(task);
  // A reload forgets the plan: back to the choices, which are one press away from a new one.
  useEffect(() => {
    if (!plan) go({ page: "setup", task }, true);
  }, [plan]);
  return plan ? (
    <Preview key={plan.plan} task={task} plan={plan} />
  ) : (
    <Page title={t.app.loading} />
  );
}

function Preview({ task, plan }: { task: string; plan: Plan }) {
  const id = useMemo(() => newId(), [plan]);
  const why = useComputed(() => whyNotReady(robot.value, connection.value));
  const held = isHeld(task);
  const start = useAction(async () => {
    const reproduction = await startReproduction(id, robotId.peek(), plan.plan, isHeld(task));
    reproductions.put(reproduction);
    go({ page: "motion", task, motion: reproduction.id }, true);
  });
  const again = useAction(() => preview(task, plan.model_id));
  const layers = useMemo<Layer[]>(
    () => [{ label: t.run.planned, joints: plan.joints_deg, look: "strong" }],
    [plan],
  );
  const time = useSignal(0);
  const problem = start.problem ?? again.problem;
  return (
    <Page
      title={t.run.previewTitle}
      back={{ page: "setup", task }}
      actions={
        <>
          <p class="remark">{held ? t.hold.nothingMoves : t.run.keepAway}</p>
          <ButtonLink to={{ page: "setup", task }} icon="back">
            {t.run.change}
          </ButtonLink>
          <Button
            look="primary"
            icon={held ? "next" : "play"}
            why={start.busy ? null : why.value}
            busy={start.busy && (held ? t.hold.gettingReady : t.run.starting)}
            onPress={start.start}
          >
            {held ? t.hold.ready : t.run.startMotion}
          </Button>
        </>
      }
    >
      {problem && <ProblemNotice problem={problem} onRetry={again.start} />}
      {plan.warnings.length > 0 && (
        <Notice tone="soft" icon="alert" title={t.run.warnings}>
          {plan.warnings.map((warning) => (
            <p key={warning}>{warning}</p>
          ))}
        </Notice>
      )}
      <PlanPicture plan={plan} time={time} />
      <RunModeChoice task={task} />
      <Notice tone="good" icon="check" title={t.run.verdict}>
        <p>{plan.verdict}</p>
      </Notice>
      <Figures
        list={[
          [t.run.duration, duration(plan.duration_s)],
          [t.run.approach, plan.approach_s > 0 ? duration(plan.approach_s) : null],
          [
            t.run.slowedLabel,
            plan.slowed_by > 1.005 ? t.run.slowed(fixed(plan.slowed_by, 1)) : null,
          ],
        ]}
      />
      <JointPanels
        title={t.run.planPlot}
        timesS={plan.t_s}
        layers={layers}
        signalsS={plan.signals.map((signal) => signal.at_s)}
        cursor={time}
        {...(plan.approach_s > 0 ? { markS: plan.approach_s } : {})}
      />
      <SignalTimes title={t.signals.planned} marks={plan.signals} />
    </Page>
  );
}
