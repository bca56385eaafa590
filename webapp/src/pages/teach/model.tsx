// A training while it runs, and its result.
import { cancelJob } from "../../api/endpoints";
import type { Model } from "../../api/types";
import { Button, ButtonLink } from "../../components/button";
import { LoadNotice, Notice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { Progress } from "../../components/progress";
import { jobs, loadModel, models } from "../../state/entities";
import { useAction, useLoad } from "../../state/hooks";
import { train, useRunAsTaught } from "../../state/training";
import { t } from "../../texts";
import { ModelResult } from "./model-result";
import { RefusedRun, RunButton } from "./run-button";
import { verdictOf } from "./verdict";

export function ModelPage({ task, model: id }: { task: string; model: string }) {
  const load = useLoad(() => loadModel(id), id);
  const model = models.get(id);
  if (!model) {
    return (
      <Page title={t.teach.training} back={{ page: "task", task }}>
        <LoadNotice load={load} empty />
      </Page>
    );
  }
  if (model.state === "training") return <Training key="training" model={model} />;
  if (model.state === "ready") return <Ready key="ready" model={model} />;
  return <Ended key="ended" model={model} />;
}

function Training({ model }: { model: Model }) {
  const job = jobs.get(model.job_id);
  const cancel = useAction(async () => {
    jobs.put(await cancelJob(model.job_id));
    await loadModel(model.id);
  });
  const queued = job?.state !== "running";
  return (
    <Page
      title={t.teach.training}
      back={{ page: "task", task: model.task_id }}
      actions={
        <Button icon="cross" busy={cancel.busy && t.teach.cancelling} onPress={cancel.start}>
          {t.teach.cancelTraining}
        </Button>
      }
    >
      <div class="card">
        <Progress
          label={t.teach.training}
          fraction={queued ? null : job.progress.fraction}
          words={queued ? t.teach.trainingQueued : job.progress.words}
        />
      </div>
      <p>{t.teach.trainingSleep}</p>
      {cancel.problem && <ProblemNotice problem={cancel.problem} />}
    </Page>
  );
}

function Ready({ model }: { model: Model }) {
  const task = model.task_id;
  const run = useRunAsTaught(task, model.id);
  const usable = verdictOf(model).light !== "red";
  return (
    <Page
      title={t.teach.trained}
      back={{ page: "task", task }}
      actions={
        <>
          <ButtonLink
            to={{ page: "record", task }}
            look={usable ? "secondary" : "primary"}
            icon="record"
          >
            {t.teach.recordAnother}
          </ButtonLink>
          <RunButton run={run} look={usable ? "primary" : "secondary"} />
        </>
      }
    >
      {run.problem && <RefusedRun task={task} problem={run.problem} />}
      <ModelResult model={model} />
    </Page>
  );
}

function Ended({ model }: { model: Model }) {
  const task = model.task_id;
  const again = useAction(() => train(task, true));
  const failed = model.state === "failed";
  return (
    <Page
      title={t.teach.training}
      back={{ page: "task", task }}
      actions={
        <>
          <Button icon="again" busy={again.busy && t.teach.trainStarting} onPress={again.start}>
            {t.teach.trainAgain}
          </Button>
          <ButtonLink to={{ page: "task", task }} look="primary" icon="back">
            {t.teach.backToTakes}
          </ButtonLink>
        </>
      }
    >
      {failed && model.failure && (
        <ProblemNotice title={t.teach.trainingFailed} problem={model.failure} />
      )}
      {!failed && (
        <Notice tone="plain" icon="info">
          <p>{t.teach.trainingCancelled}</p>
        </Notice>
      )}
      {again.problem && <ProblemNotice problem={again.problem} />}
    </Page>
  );
}
