// One task: its takes, its trained motion, and the next step put forward.
import { useSignal } from "@preact/signals";
import type { Demonstration, Model, TaskAgreement } from "../../api/types";
import { Button, ButtonLink } from "../../components/button";
import { LoadNotice, Notice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { RowLink } from "../../components/row-link";
import { TaskPicture } from "../../components/task-picture";
import { UndoNotice } from "../../components/undo-notice";
import { useAgreement } from "../../state/agreement";
import { lastDecision, takeBack } from "../../state/decisions";
import { demonstrations, loadAllOf, models, readyModel, tasks } from "../../state/entities";
import { useAction, useLoad, type Action } from "../../state/hooks";
import { ENOUGH_TAKES, isFrom, nextStep, type NextStep } from "../../state/next-step";
import { train, useRunAsTaught } from "../../state/training";
import { t } from "../../texts";
import { RefusedRun, RunButton } from "./run-button";
import { TakeList } from "./take-list";
import { TakesAdvice } from "./takes-advice";

export function TaskPage({ task }: { task: string }) {
  const load = useLoad(() => loadAllOf(task), task);
  const takes = demonstrations.where((take) => take.task_id === task);
  const trained = models.where((model) => model.task_id === task);
  const kept = takes.filter((take) => take.state === "kept").length;
  const compared = useAgreement(task);
  const training = useAction(() => train(task));
  const ready = readyModel(task);
  const run = useRunAsTaught(task, ready?.id ?? "");
  const known = tasks.get(task);
  // No next step is put forward before all takes are known: it could be the wrong one.
  const complete = useSignal(false);
  if (known && !load.loading && !load.problem) complete.value = true;
  const step = nextStep(takes, trained);
  return (
    <Page
      title={known?.name ?? t.app.loading}
      back={{ page: "teach" }}
      actions={
        complete.value ? (
          <Actions {...{ task, step, kept, train: training, run, agreement: compared.agreement }} />
        ) : (
          <div class="later" />
        )
      }
    >
      <LoadNotice load={load} empty={known === undefined} />
      {training.problem && <ProblemNotice problem={training.problem} />}
      {run.problem && <RefusedRun task={task} problem={run.problem} />}
      <LastDecision task={task} />
      {known && (
        <>
          <Result task={task} model={ready} isCurrent={isCurrent(ready, takes, step)} />
          <h2>{t.teach.takes}</h2>
          <div class="picture-line">
            <TaskPicture task={known} />
            <Kept takes={takes} kept={kept} />
          </div>
          {takes.length > 0 && <TakesAdvice compared={compared} />}
          <TakeList task={task} takes={takes} agreement={compared.agreement} />
          <ButtonLink to={{ page: "more", task }} look="quiet" icon="dots">
            {t.teach.more}
          </ButtonLink>
        </>
      )}
    </Page>
  );
}

/** Whether nothing was cut or chosen otherwise since the training; what is under way comes first. */
function isCurrent(model: Model | undefined, takes: Demonstration[], { step }: NextStep): boolean {
  const kept = takes.filter((take) => take.state === "kept");
  return model === undefined || (step !== "train" && step !== "record") || isFrom(model, kept);
}

/** What was decided last, with the way back. */
function LastDecision({ task }: { task: string }) {
  const last = lastDecision.value;
  if (last?.take.task_id !== task) return null;
  const words = last.take.state === "kept" ? t.teaching.undo.kept : t.teaching.undo.discarded;
  return <UndoNotice words={words(last.take.take)} undo={() => takeBack(last)} />;
}

interface ResultProps {
  task: string;
  model: Model | undefined;
  isCurrent: boolean;
}

function Result({ task, model, isCurrent }: ResultProps) {
  if (!model) return null;
  return (
    <>
      <ul class="rows">
        <RowLink to={{ page: "model", task, model: model.id }}>
          <span class="row-name">
            <strong>{t.teach.result}</strong>
            <span>{t.teach.version(model.version)}</span>
          </span>
        </RowLink>
      </ul>
      {!isCurrent && (
        <Notice tone="soft" icon="train">
          <p>{t.teaching.trim.changedSince}</p>
        </Notice>
      )}
    </>
  );
}

function Kept({ takes, kept }: { takes: Demonstration[]; kept: number }) {
  if (takes.length === 0) return <p>{t.teach.noTakes}</p>;
  return <p>{kept >= ENOUGH_TAKES ? t.teach.keptEnough(kept) : t.teach.keptCount(kept)}</p>;
}

interface ActionsProps {
  task: string;
  step: NextStep;
  kept: number;
  train: Action;
  run: Action;
  agreement: TaskAgreement | null;
}

function Actions({ task, step, kept, train, run, agreement }: ActionsProps) {
  // Only the looks follow the advice: a button must not move away under a finger.
  const open = agreement?.enough === false;
  // Takes that can't be trained together don't get better by one more.
  const another = open && !agreement.problem;
  switch (step.step) {
    case "recording":
      return (
        <ButtonLink to={{ page: "take", task, take: step.take.id }} look="primary" icon="record">
          {t.teach.toRecording}
        </ButtonLink>
      );
    case "decide":
      return (
        <ButtonLink to={{ page: "take", task, take: step.take.id }} look="primary" icon="eye">
          {t.teach.lookAt(step.take.take)}
        </ButtonLink>
      );
    case "training":
      return (
        <ButtonLink to={{ page: "model", task, model: step.model.id }} look="primary" icon="train">
          {t.teach.toTraining}
        </ButtonLink>
      );
    case "result":
      return (
        <>
          <RecordLink task={task} look="secondary" another />
          <RunButton run={run} look="primary" />
        </>
      );
    case "train":
      return (
        <>
          <RecordLink task={task} look={another ? "primary" : "secondary"} another />
          <TrainButton train={train} look={open ? "secondary" : "primary"} kept={kept} />
        </>
      );
    case "record":
      return (
        <>
          {kept > 0 && <TrainButton train={train} look="secondary" kept={kept} />}
          <RecordLink task={task} look="primary" another={kept > 0} />
        </>
      );
  }
}

function RecordLink(props: { task: string; look: "primary" | "secondary"; another: boolean }) {
  return (
    <ButtonLink to={{ page: "record", task: props.task }} look={props.look} icon="record">
      {props.another ? t.teach.recordAnother : t.teach.record}
    </ButtonLink>
  );
}

function TrainButton(props: { train: Action; look: "primary" | "secondary"; kept: number }) {
  return (
    <Button
      look={props.look}
      icon="train"
      why={props.kept === 0 ? t.teach.trainNeeds : null}
      busy={props.train.busy && t.teach.trainStarting}
      onPress={props.train.start}
    >
      {t.teach.train}
    </Button>
  );
}
