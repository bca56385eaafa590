// What workers say: a radar plot for each task, or for one task over the weeks or months.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { questionnaireResults } from "../../api/endpoints";
import type { Grouping, QuestionnaireResult } from "../../api/types";
import { Choice } from "../../components/choice";
import { LoadNotice } from "../../components/notice";
import { day, month } from "../../format/when";
import { Radar } from "../../plots/radar";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";

/** Answers come in a few times a shift. */
const EVERY_MS = 30_000;
/** So many weeks or months are drawn, the latest ones. */
const PERIODS = 6;
const GROUPINGS: readonly Grouping[] = ["all", "week", "month"];

interface Answer {
  by: Grouping;
  results: QuestionnaireResult[];
}

export function Answers() {
  const by = useSignal<Grouping>("all");
  const task = useSignal<string | null>(null);
  const answer = useSignal<Answer | null>(null);
  const load = useLoad(async () => {
    const wanted = by.peek();
    const results = await questionnaireResults(wanted);
    if (wanted === by.peek()) answer.value = { by: wanted, results };
  }, by.value);
  useEffect(() => {
    const timer = setInterval(load.again, EVERY_MS);
    return () => clearInterval(timer);
  }, [load.again]);
  const known = answer.value?.by === by.value ? answer.value.results : null;
  const none = known?.length === 0;
  return (
    <>
      <LoadNotice load={load} empty={known === null} />
      {none && <p>{t.dashboard.noAnswers}</p>}
      {!none && (
        <Choice
          row
          legend={t.dashboard.grouping}
          options={GROUPINGS.map((value) => ({ value, name: t.dashboard.groupings[value] }))}
          value={by.value}
          onChoose={(value) => (by.value = value)}
        />
      )}
      {known && !none && by.value === "all" && (
        <Radars list={known} title={(one) => one.task_name} />
      )}
      {known && !none && by.value !== "all" && (
        <OverTime
          results={known}
          by={by.value}
          task={task.value}
          onTask={(id) => (task.value = id)}
        />
      )}
    </>
  );
}

interface OverTimeProps {
  results: QuestionnaireResult[];
  by: Grouping;
  task: string | null;
  onTask: (task: string) => void;
}

function OverTime({ results, by, task, onTask }: OverTimeProps) {
  const names = new Map(results.map((one) => [one.task_id, one.task_name]));
  const chosen = task !== null && names.has(task) ? task : results[0]?.task_id;
  const list = results.filter((one) => one.task_id === chosen).slice(-PERIODS);
  const title = ({ from }: QuestionnaireResult) =>
    by === "week" ? t.dashboard.week(day(from)) : month(from);
  return (
    <>
      <label class="field">
        <span>{t.dashboard.whichTask}</span>
        <select value={chosen} onChange={(event) => onTask(event.currentTarget.value)}>
          {[...names].map(([id, name]) => (
            <option key={id} value={id}>
              {name}
            </option>
          ))}
        </select>
      </label>
      <Radars list={list} title={title} />
    </>
  );
}

interface RadarsProps {
  list: QuestionnaireResult[];
  title: (result: QuestionnaireResult) => string;
}

function Radars({ list, title }: RadarsProps) {
  return (
    <div class="radars">
      {list.map((one) => (
        <Radar key={`${one.task_id} ${one.from}`} title={title(one)} result={one} />
      ))}
    </div>
  );
}
