// The overview of the cell for operators: robots, running work, results and what workers say,
// followed live, and said to be old as soon as it is.
import type { ComponentChildren } from "preact";
import type { Dashboard } from "../../api/types";
import { Icon } from "../../components/icon";
import { Notice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { Progress } from "../../components/progress";
import { age, duration } from "../../format/numbers";
import {
  dashboard,
  dashboardAgeMs,
  dashboardProblem,
  OLD_AFTER_MS,
  useDashboard,
} from "../../state/dashboard";
import { robotStatus } from "../../state/robot-status";
import { t } from "../../texts";
import { Answers } from "./answers";
import { RunsTable, TasksTable } from "./tables";

export function DashboardPage() {
  useDashboard();
  const shown = dashboard.value;
  const problem = dashboardProblem.value;
  return (
    <Page title={t.dashboard.title} back={{ page: "run" }}>
      {!shown && problem && <ProblemNotice problem={problem} />}
      {!shown && !problem && (
        <p class="loading" role="status">
          <span class="spinner" aria-hidden="true" />
          {t.app.loading}
        </p>
      )}
      {shown && <Overview shown={shown} />}
    </Page>
  );
}

function Overview({ shown }: { shown: Dashboard }) {
  const ageMs = dashboardAgeMs.value;
  const old = ageMs > OLD_AFTER_MS;
  return (
    <div class="dashboard">
      {old ? (
        <Notice tone="soft" icon="clock">
          <p>{t.dashboard.old(age(ageMs))}</p>
        </Notice>
      ) : (
        <p class="hint">{ageMs < 3000 ? t.dashboard.now : t.dashboard.age(age(ageMs))}</p>
      )}
      <div class="dashboard-top">
        <Part title={t.dashboard.robots}>
          <Robots shown={shown} old={old} ageMs={ageMs} />
        </Part>
        <Part title={t.dashboard.work}>
          <Work shown={shown} />
        </Part>
      </div>
      <Part title={t.dashboard.runs}>
        {shown.runs.length > 0 ? <RunsTable runs={shown.runs} /> : <p>{t.dashboard.noRuns}</p>}
      </Part>
      <Part title={t.dashboard.tasks}>
        {shown.tasks.length > 0 ? <TasksTable tasks={shown.tasks} /> : <p>{t.dashboard.noTasks}</p>}
      </Part>
      <Part title={t.dashboard.answers}>
        <Answers />
      </Part>
    </div>
  );
}

function Part({ title, children }: { title: string; children: ComponentChildren }) {
  return (
    <section class="dashboard-part" aria-label={title}>
      <h2>{title}</h2>
      {children}
    </section>
  );
}

function Robots({ shown, old, ageMs }: { shown: Dashboard; old: boolean; ageMs: number }) {
  return (
    <ul class="rows">
      {shown.robots.map((one) => {
        const status = robotStatus(one, old ? "lost" : "live", old ? ageMs : 0);
        return (
          <li key={one.id} class="card">
            <strong>{one.name}</strong>
            <span class={`state tone-${status.tone}`}>
              <Icon name={status.icon} />
              {status.word}
            </span>
            {status.stale && status.age && <span class="hint">{status.age}</span>}
            {one.fault && <span>{one.fault.message}</span>}
          </li>
        );
      })}
    </ul>
  );
}

/** What takes a while: arms that move, and trainings. */
function Work({ shown }: { shown: Dashboard }) {
  const moving = shown.robots.filter((one) => one.run);
  if (moving.length === 0 && shown.jobs.length === 0) return <p>{t.dashboard.noWork}</p>;
  const task = (id: string) =>
    shown.tasks.find((one) => one.task_id === id)?.name ?? t.dashboard.unknownTask;
  const phases: Record<string, string> = t.run.phases;
  return (
    <ul class="rows">
      {moving.map(
        ({ id, name, run }) =>
          run && (
            <li key={id} class="card">
              <strong>{t.dashboard.moving(name)}</strong>
              <span>{phases[run.phase]}</span>
              <Progress
                label={t.dashboard.moving(name)}
                fraction={run.duration_s > 0 ? run.t_s / run.duration_s : null}
                words={t.run.of(duration(run.t_s), duration(run.duration_s))}
              />
            </li>
          ),
      )}
      {shown.jobs.map((job) => (
        <li key={job.id} class="card">
          <strong>{t.dashboard.training(task(job.task_id))}</strong>
          <Progress
            label={t.dashboard.training(task(job.task_id))}
            fraction={job.progress.fraction}
            words={job.state === "queued" ? t.dashboard.waits : job.progress.words}
          />
        </li>
      ))}
    </ul>
  );
}
