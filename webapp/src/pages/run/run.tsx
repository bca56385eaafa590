// Run, first screen: the tasks, those with a trained motion first.
import { ButtonLink } from "../../components/button";
import { LoadNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { OpenWork } from "../../components/open-work";
import { RowLink } from "../../components/row-link";
import { TaskPicture } from "../../components/task-picture";
import { loadOverview, readyModel, tasks } from "../../state/entities";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";

export function RunPage() {
  const load = useLoad(loadOverview, "run");
  const trained = tasks.where((task) => readyModel(task.id) !== undefined);
  const nothing = trained.length === 0 && !load.loading && !load.problem;
  return (
    <Page
      title={t.run.title}
      first
      actions={
        nothing && (
          <ButtonLink to={{ page: "teach" }} look="primary" icon="teach">
            {t.run.toTeach}
          </ButtonLink>
        )
      }
    >
      <OpenWork />
      <LoadNotice load={load} empty={trained.length === 0} />
      <p>{nothing ? t.run.none : trained.length > 0 && t.run.choose}</p>
      <ul class="rows">
        {trained.map((task) => (
          <RowLink
            key={task.id}
            to={{ page: "setup", task: task.id }}
            label={t.run.open(task.name)}
          >
            <TaskPicture task={task} />
            <strong class="row-name">{task.name}</strong>
          </RowLink>
        ))}
      </ul>
      <ButtonLink to={{ page: "dashboard" }} look="quiet" icon="train">
        {t.dashboard.open}
      </ButtonLink>
    </Page>
  );
}
