// A task in the list, with how far it is: what waits for a decision is said here already.
import type { Task } from "../../api/types";
import { Icon } from "../../components/icon";
import { RowLink } from "../../components/row-link";
import { TaskPicture } from "../../components/task-picture";
import { demonstrations, readyModel } from "../../state/entities";
import { t } from "../../texts";
import { TAKE_LOOKS } from "./take-list";

export function TaskRow({ task }: { task: Task }) {
  const takes = demonstrations.where((take) => take.task_id === task.id);
  const kept = takes.filter((take) => take.state === "kept").length;
  const waiting = takes.find((take) => take.state === "interrupted" || take.state === "recorded");
  // In the name too: whoever hears the list wants to know how far each task is.
  const state = waiting
    ? t.teach.waiting(waiting.take, t.teach.states[waiting.state])
    : readyModel(task.id)
      ? t.teach.isTrained
      : t.teach.keptCount(kept);
  return (
    <RowLink to={{ page: "task", task: task.id }} label={`${t.teach.open(task.name)}, ${state}`}>
      <TaskPicture task={task} />
      <span class="row-name">
        <strong>{task.name}</strong>{" "}
        {waiting ? (
          <span class="state tone-soft">
            <Icon name={TAKE_LOOKS[waiting.state].icon} />
            {state}
          </span>
        ) : readyModel(task.id) ? (
          <span class="state tone-good">
            <Icon name="check" />
            {state}
          </span>
        ) : (
          <span>{state}</span>
        )}
      </span>
    </RowLink>
  );
}
