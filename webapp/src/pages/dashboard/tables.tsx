// The overview's two tables: the latest runs, and the counts of each task. On a phone each row
// becomes a card; the roles keep it a table for screen readers.
import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import type { RunSummary, TaskSummary } from "../../api/types";
import { Button } from "../../components/button";
import { RunState, Worked } from "../../components/run-state";
import { errorDegrees, fixed, percent } from "../../format/numbers";
import { moment } from "../../format/when";
import { link } from "../../router";
import { t } from "../../texts";

interface Row {
  key: string;
  /** One for each column; null is nothing to show. */
  cells: ComponentChildren[];
}

function Table({ label, columns, rows }: { label: string; columns: string[]; rows: Row[] }) {
  return (
    <table class="overview" role="table" aria-label={label}>
      <thead role="rowgroup">
        <tr role="row">
          {columns.map((name) => (
            <th key={name} role="columnheader" scope="col">
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody role="rowgroup">
        {rows.map(({ key, cells: [head, ...cells] }) => (
          <tr key={key} role="row">
            <th role="rowheader" scope="row">
              {head}
            </th>
            {cells.map((cell, at) => (
              <td key={at} role="cell" data-label={columns[at + 1]}>
                {cell ?? "–"}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** So many runs are shown until somebody wants to see all: what is below has to be found too. */
const SHOWN = 6;

export function RunsTable({ runs }: { runs: readonly RunSummary[] }) {
  const all = useSignal(false);
  return (
    <>
      <Runs runs={all.value ? runs : runs.slice(0, SHOWN)} />
      {!all.value && runs.length > SHOWN && (
        <Button icon="plus" onPress={() => (all.value = true)}>
          {t.dashboard.showAll(String(runs.length))}
        </Button>
      )}
    </>
  );
}

function Runs({ runs }: { runs: readonly RunSummary[] }) {
  const names = t.dashboard.columns;
  return (
    <Table
      label={t.dashboard.runs}
      columns={[names.task, names.when, names.state, names.e_j, names.gmcc, names.worked]}
      rows={runs.map((run) => {
        const when = moment(run.created_at);
        return {
          key: run.id,
          cells: [
            <a
              class="cell-link"
              href={link({ page: "motion", task: run.task_id, motion: run.id })}
              aria-label={t.dashboard.openRun(run.task_name, when)}
            >
              {run.task_name}
            </a>,
            when,
            <RunState state={run.state} />,
            run.e_j_deg == null ? null : errorDegrees(run.e_j_deg, 3),
            run.gmcc == null ? null : fixed(run.gmcc, 4),
            <Worked worked={run.worked} />,
          ],
        };
      })}
    />
  );
}

export function TasksTable({ tasks }: { tasks: readonly TaskSummary[] }) {
  const names = t.dashboard.columns;
  return (
    <Table
      label={t.dashboard.tasks}
      columns={[
        names.task,
        names.runs,
        names.succeeded,
        names.share,
        names.e_j,
        names.gmcc,
        names.last,
      ]}
      rows={tasks.map((task) => ({
        key: task.task_id,
        cells: [
          <a class="cell-link" href={link({ page: "setup", task: task.task_id })}>
            {task.name}
          </a>,
          String(task.runs),
          String(task.succeeded),
          task.judged === 0 ? null : share(task),
          task.e_j_mean_deg == null ? null : errorDegrees(task.e_j_mean_deg, 3),
          task.gmcc_mean == null ? null : fixed(task.gmcc_mean, 4),
          task.last_run_at == null ? null : moment(task.last_run_at),
        ],
      }))}
    />
  );
}

/** Of those runs of which somebody said it: a share of all would blame the silent ones. */
function share({ worked, judged }: TaskSummary): string {
  return t.dashboard.shareOf(percent(worked / judged), String(worked), String(judged));
}
