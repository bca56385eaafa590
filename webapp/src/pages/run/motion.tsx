// A run while the arm moves, and what came of it.
import { useComputed } from "@preact/signals";
import type { Reproduction, RobotView } from "../../api/types";
import { Button, ButtonLink } from "../../components/button";
import { LoadNotice, ProblemNotice } from "../../components/notice";
import { OfflineNotice } from "../../components/offline-notice";
import { Page } from "../../components/page";
import { Progress } from "../../components/progress";
import { duration } from "../../format/numbers";
import { LiveTraces } from "../../plots/live-traces";
import { loadReproduction, readyModel, reproductions, loadModels } from "../../state/entities";
import { useAction, useLoad } from "../../state/hooks";
import { robot } from "../../state/live";
import { go } from "../../state/navigation";
import { preview, previewWayBack } from "../../state/run-setup";
import { useWakeLock } from "../../state/wake-lock";
import { t } from "../../texts";
import { MotionResult } from "./motion-result";
import { HoldButton } from "./hold-button";
import { Pace, PaceSteps } from "./pace";

export function MotionPage({ task, motion: id }: { task: string; motion: string }) {
  const load = useLoad(() => loadReproduction(id), id);
  const motion = reproductions.get(id);
  if (!motion) {
    return (
      <Page title={t.run.title} back={{ page: "setup", task }}>
        <LoadNotice load={load} empty />
      </Page>
    );
  }
  return motion.state === "running" ? (
    <Moving key="moving" motion={id} />
  ) : (
    <Finished key="finished" motion={motion} />
  );
}

function Moving({ motion }: { motion: string }) {
  useWakeLock(true);
  const text = useComputed(() => JSON.stringify(robot.value?.run ?? null));
  const run = JSON.parse(text.value) as RobotView["run"] | null;
  const phases: Record<string, string> = t.run.phases;
  const times = run ? t.run.of(duration(run.t_s), duration(run.duration_s)) : "";
  return (
    <Page
      title={titleOf(run)}
      actions={
        run &&
        (run.held === null ? (
          <Pace motion={motion} speed={run.speed} paused={run.paused} />
        ) : (
          <HoldButton motion={motion} />
        ))
      }
    >
      <OfflineNotice />
      {run && run.held !== null && <p>{t.hold.keepClear}</p>}
      <div class="card tone-moving">
        <p class="phase" role="status">
          {(run && phases[run.phase]) ?? t.run.phases.waiting}
        </p>
        <Progress
          label={t.run.progress}
          fraction={run && run.duration_s > 0 ? run.t_s / run.duration_s : null}
          words={times}
        />
      </div>
      {run && run.held !== null && (
        <section class="pace" aria-label={t.run.pace.title}>
          <PaceSteps motion={motion} speed={run.speed} />
        </section>
      )}
      <LiveTraces />
    </Page>
  );
}

function titleOf(run: RobotView["run"] | null): string {
  if (run?.held === false) return t.hold.waits;
  return run?.phase === "paused" ? t.run.waiting : t.run.moving;
}

function Finished({ motion }: { motion: Reproduction }) {
  const task = motion.task_id;
  const again = useAction(async () => {
    await loadModels(task);
    await preview(task, readyModel(task)?.id ?? motion.model_id);
    go({ page: "preview", task });
  });
  const back = useAction(async () => {
    await previewWayBack(task, motion.id);
    go({ page: "preview", task });
  });
  const problem = again.problem ?? back.problem;
  return (
    <Page
      title={t.run.states[motion.state]}
      back={{ page: "run" }}
      actions={
        <>
          <ButtonLink to={{ page: "setup", task }} icon="pencil">
            {t.run.otherGoal}
          </ButtonLink>
          <Button
            look="primary"
            icon="again"
            busy={again.busy && t.run.previewing}
            onPress={again.start}
          >
            {t.run.again}
          </Button>
        </>
      }
    >
      {problem && <ProblemNotice title={t.run.refused} problem={problem} />}
      {motion.state === "stopped" && (
        <Button icon="back" busy={back.busy && t.run.planningBack} onPress={back.start}>
          {t.run.back}
        </Button>
      )}
      <MotionResult motion={motion} />
    </Page>
  );
}
