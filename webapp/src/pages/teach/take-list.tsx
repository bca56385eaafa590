// The takes of a task with a small picture, length and state each; discarded ones folded away.
import type { Demonstration, DemonstrationState, TaskAgreement, Verdict } from "../../api/types";
import { Icon, type IconName } from "../../components/icon";
import { RowLink } from "../../components/row-link";
import { duration } from "../../format/numbers";
import { TakeSparkline } from "../../plots/sparkline";
import { t } from "../../texts";

/** How long the stretch is that is used. */
export function usedS({ trim, duration_s }: Demonstration): number {
  return trim ? trim.to_s - trim.from_s : duration_s;
}

export const TAKE_LOOKS: Record<DemonstrationState, { icon: IconName; tone: string }> = {
  preparing: { icon: "clock", tone: "moving" },
  recording: { icon: "record", tone: "bad" },
  recorded: { icon: "eye", tone: "soft" },
  kept: { icon: "check", tone: "good" },
  discarded: { icon: "bin", tone: "stale" },
  interrupted: { icon: "alert", tone: "soft" },
};

/** What is said of a take beside the others. */
const MARKS: Record<Verdict, { icon: IconName; tone: string }> = {
  agrees: { icon: "check", tone: "good" },
  differs: { icon: "alert", tone: "soft" },
  other_motion: { icon: "alert", tone: "bad" },
  unusable: { icon: "alert", tone: "bad" },
  open: { icon: "info", tone: "stale" },
};

interface TakesProps {
  task: string;
  takes: Demonstration[];
  agreement: TaskAgreement | null;
}

export function TakeList({ task, takes, agreement }: TakesProps) {
  const byTake = [...takes].sort((left, right) => left.take - right.take);
  const discarded = byTake.filter((take) => take.state === "discarded");
  const rows = (list: Demonstration[]) => (
    <ul class="rows">
      {list.map((take) => (
        <TakeRow key={take.id} {...{ task, take, agreement }} />
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

interface TakeProps {
  task: string;
  take: Demonstration;
  agreement: TaskAgreement | null;
}

function TakeRow({ task, take, agreement }: TakeProps) {
  const state = t.teach.states[take.state];
  const look = TAKE_LOOKS[take.state];
  const closed = take.state !== "preparing" && take.state !== "recording";
  const compared = agreement?.takes.find((one) => one.id === take.id);
  const words = compared?.words ?? undefined;
  const length = duration(usedS(take));
  return (
    <RowLink
      to={{ page: "take", task, take: take.id }}
      label={[t.teach.openTake(take.take, state, words), length, take.problem]
        .filter(Boolean)
        .join(", ")}
    >
      {closed && <TakeSparkline take={take.id} trim={take.trim} />}
      <span class="row-name">
        <strong>{t.teach.take(take.take)}</strong>{" "}
        <span class="row-states">
          <span class={`state tone-${look.tone}`}>
            <Icon name={look.icon} />
            {state}
          </span>{" "}
          {compared && words && (
            <span class={`state tone-${MARKS[compared.verdict].tone}`}>
              <Icon name={MARKS[compared.verdict].icon} />
              {words}
            </span>
          )}{" "}
          <span>{length}</span>
        </span>{" "}
        {take.problem && <span class="row-problem">{take.problem}</span>}
      </span>
    </RowLink>
  );
}
