// Before a run: where it ends, where it begins, how fast. Then the preview.
import { useComputed } from "@preact/signals";
import type { Model } from "../../api/types";
import { Button, ButtonLink } from "../../components/button";
import { Choice } from "../../components/choice";
import { LoadNotice, Notice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { degrees, percent } from "../../format/numbers";
import { loadModels, loadTask, readyModel, tasks } from "../../state/entities";
import { useAction, useLoad } from "../../state/hooks";
import { robot } from "../../state/live";
import { go } from "../../state/navigation";
import {
  asTyped,
  change,
  lacksPosition,
  planRequest,
  preview,
  setupOf,
  SPEEDS,
  type GoalChoice,
  type StartChoice,
} from "../../state/run-setup";
import { t } from "../../texts";
import { JointInputs } from "./joint-inputs";
import { RecentRuns } from "./recent-runs";
import { SavedChoice } from "./saved-choice";

export function SetupPage({ task }: { task: string }) {
  const load = useLoad(async () => {
    await Promise.all([loadTask(task), loadModels(task)]);
  }, task);
  const model = readyModel(task);
  const name = tasks.get(task)?.name ?? t.app.loading;
  if (model) return <Setup key={model.id} task={task} name={name} model={model} />;
  return (
    <Page
      title={name}
      back={{ page: "run" }}
      actions={
        !load.loading && (
          <ButtonLink to={{ page: "task", task }} look="primary" icon="teach">
            {t.run.toTeach}
          </ButtonLink>
        )
      }
    >
      <LoadNotice load={load} empty />
      {!load.loading && !load.problem && <p>{t.run.notTrained}</p>}
    </Page>
  );
}

function Setup({ task, name, model }: { task: string; name: string; model: Model }) {
  const setup = setupOf(task);
  const plan = useAction(async () => {
    await preview(task, model.id);
    go({ page: "preview", task });
  });
  const chooseGoal = (goal: GoalChoice) => {
    const first =
      setup.typed.length === 0 && model.goal_deg ? asTyped(model.goal_deg) : setup.typed;
    change(task, { goal, typed: first });
  };
  const incomplete = planRequest(model.id, setup) === null;
  const toDo = lacksPosition(setup) ? t.positions.chooseFirst : t.run.fixNumbers;
  const goals = { ...t.run.goals, saved: t.positions.choice };
  const starts = { ...t.run.starts, saved: t.positions.choice };
  return (
    <Page
      title={name}
      back={{ page: "run" }}
      actions={
        <Button
          look="primary"
          icon="eye"
          why={incomplete ? toDo : null}
          busy={plan.busy && t.run.previewing}
          onPress={plan.start}
        >
          {t.run.preview}
        </Button>
      }
    >
      {plan.problem && <ProblemNotice title={t.run.refused} problem={plan.problem} />}
      <Choice
        legend={t.run.goal}
        options={options(["as_taught", "present", "saved", "typed"] as const, goals)}
        value={setup.goal}
        onChoose={chooseGoal}
      />
      {setup.goal === "typed" && (
        <JointInputs values={setup.typed} onChange={(typed) => change(task, { typed })} />
      )}
      {setup.goal === "saved" && (
        <SavedChoice
          task={task}
          legend={t.positions.goal}
          value={setup.goalPosition}
          onChoose={(goalPosition) => change(task, { goalPosition })}
        />
      )}
      {(setup.goal === "present" || setup.start === "present") && <PresentJoints />}
      <Choice<StartChoice>
        legend={t.run.start}
        options={options(["as_taught", "present", "saved"] as const, starts)}
        value={setup.start}
        onChoose={(start) => change(task, { start })}
      />
      {setup.start === "saved" && (
        <SavedChoice
          task={task}
          legend={t.positions.start}
          value={setup.startPosition}
          onChoose={(startPosition) => change(task, { startPosition })}
        />
      )}
      <Choice
        row
        legend={t.run.speed}
        options={SPEEDS.map((speed) => ({
          value: speed,
          name: t.run.speeds[speed] ?? speed,
          detail: percent(Number(speed)),
        }))}
        value={setup.speed}
        onChoose={(speed) => change(task, { speed })}
      />
      <RecentRuns task={task} />
    </Page>
  );
}

function options<T extends string>(
  values: readonly T[],
  words: Record<T, { name: string; detail: string }>,
) {
  return values.map((value) => ({ value, ...words[value] }));
}

function PresentJoints() {
  const angles = useComputed(() => {
    const joints = robot.value?.joints_deg;
    return joints ? joints.map((value) => degrees(value)).join(", ") : null;
  });
  return (
    <Notice tone="plain" icon="info">
      <p>{angles.value === null ? t.run.presentMissing : t.run.present(angles.value)}</p>
    </Notice>
  );
}
