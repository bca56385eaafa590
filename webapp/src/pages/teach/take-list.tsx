// The takes of a task with a small picture, length and state each; discarded ones folded away.
import type { Demonstration, DemonstrationState } from "../../api/types";
import { Icon, type IconName } from "../../components/icon";
import { RowLink } from "../../components/row-link";
import { duration } from "../../format/numbers";
import { TakeSparkline } from "../../plots/sparkline";
import { t } from "../../texts";

export const TAKE_LOOKS: Record<DemonstrationState, { icon: IconName; tone: string }> = {
  preparing: { icon: "clock", tone: "moving" },
  recording: { icon: "record", tone: "bad" },
  recorded: { icon: "eye", tone: "soft" },
  kept: { icon: "check", tone: "good" },
  discarded: { icon: "bin", tone: "stale" },
  interrupted: { icon: "alert", tone: "soft" },
};

export function TakeList({ task, takes }: { task: string; takes: Demonstration[] }) {
  const byTake = [...takes].sort((left, right) => left.take - right.take);
  const discarded = byTake.filter((take) => take.state === "discarded");
  const rows = (list: Demonstration[]) => (
    <ul class="rows">
      {list.map((take) => (
        <TakeRow key={take.id} task={task} take={take} />
      ))}
    </ul>
  );
  return (
    <>
      {rows(byTake.filter((take) => take.state !== "discarded"))}
      {discarded.length > 0 && (
        <details class="folded">
          <summary>{t.teach.discardedTakes(discarded.length)}</summary>
          {rows(discarded)}
        </details>
      )}
    </>
  );
}

function TakeRow({ task, take }: { task: string; take: Demonstration }) {
  const state = t.teach.states[take.state];
  const look = TAKE_LOOKS[take.state];
  const closed = take.state !== "preparing" && take.state !== "recording";
  return (
    <RowLink to={{ page: "take", task, take: take.id }} label={t.teach.openTake(take.take, state)}>
      {closed && <TakeSparkline take={take.id} />}
      <span class="row-name">
        <strong>
          {t.teach.take(take.take)} · {duration(take.duration_s)}
        </strong>
        <span class={`state tone-${look.tone}`}>
          <Icon name={look.icon} />
          {state}
        </span>
        {take.problem && <span class="row-problem">{take.problem}</span>}
      </span>
    </RowLink>
  );
}
