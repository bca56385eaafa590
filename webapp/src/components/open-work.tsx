// What is going on right now, as ways to its screen: for a phone that was reloaded or joins late.
import { demonstrations, jobs, reproductions } from "../state/entities";
import { isOurs } from "../state/robots";
import { t } from "../texts";
import { Icon } from "./icon";
import { RowLink } from "./row-link";

export function OpenWork() {
  const recording = demonstrations.where(
    (take) => isOurs(take) && (take.state === "preparing" || take.state === "recording"),
  );
  const training = jobs.where((job) => job.state === "queued" || job.state === "running");
  const moving = reproductions.where((motion) => isOurs(motion) && motion.state === "running");
  return (
    <ul class="rows">
      {moving.map((motion) => (
        <RowLink key={motion.id} to={{ page: "motion", task: motion.task_id, motion: motion.id }}>
          <span class="state row-name tone-moving">
            <Icon name="move" />
            {t.run.moving}
          </span>
        </RowLink>
      ))}
      {recording.map((take) => (
        <RowLink key={take.id} to={{ page: "take", task: take.task_id, take: take.id }}>
          {take.paused_at_deg ? (
            <span class="state row-name tone-soft">
              <Icon name="pause" />
              {t.teaching.pause.paused}
            </span>
          ) : (
            <span class="state row-name tone-bad">
              <Icon name="record" />
              {t.teach.recordingNow}
            </span>
          )}
        </RowLink>
      ))}
      {training.map((job) => (
        <RowLink key={job.id} to={{ page: "model", task: job.task_id, model: job.model_id }}>
          <span class="state row-name tone-moving">
            <Icon name="train" />
            {t.teach.training}
          </span>
        </RowLink>
      ))}
    </ul>
  );
}
