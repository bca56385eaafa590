// Teach, first screen: the tasks.
import { ButtonLink } from "../../components/button";
import { LoadNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { OpenWork } from "../../components/open-work";
import { UndoNotice } from "../../components/undo-notice";
import { lastDeleted, restoreTask } from "../../state/decisions";
import { PhoneCorner } from "../../components/phone-corner";
import { loadOverview, tasks } from "../../state/entities";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";
import { TaskRow } from "./task-row";

export function TeachPage() {
  const load = useLoad(loadOverview, "tasks");
  const deleted = lastDeleted.value;
  const list = tasks.where(() => true);
  return (
    <Page
      title={t.teach.title}
      first
      actions={
        <ButtonLink to={{ page: "new-task" }} look="primary" icon="plus">
          {t.teach.newTask}
        </ButtonLink>
      }
    >
      {deleted && (
        <UndoNotice
          words={t.teaching.undo.deleted(deleted.name)}
          undo={async () => {
            await restoreTask(deleted);
            load.again();
          }}
        />
      )}
      <OpenWork />
      <LoadNotice load={load} empty={list.length === 0} />
      {list.length > 0 && <p>{t.teach.choose}</p>}
      {list.length === 0 && !load.loading && !load.problem && <p>{t.teach.none}</p>}
      <ul class="rows">
        {list.map((task) => (
          <TaskRow key={task.id} task={task} />
        ))}
      </ul>
      <PhoneCorner />
    </Page>
  );
}
