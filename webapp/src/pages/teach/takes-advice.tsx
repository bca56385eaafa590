// What to do about the takes, in one sentence: record another, enough, or which one differs.
import type { TaskAgreement } from "../../api/types";
import type { IconName } from "../../components/icon";
import { LoadNotice, Notice } from "../../components/notice";
import type { Compared } from "../../state/agreement";
import { t } from "../../texts";

/** A take that differs is no news that may be missed. */
function iconFor({ enough, takes }: TaskAgreement): IconName {
  const odd = takes.some((take) => take.verdict !== "agrees" && take.verdict !== "open");
  return enough ? "check" : odd ? "alert" : "info";
}

export function TakesAdvice({ compared: { agreement, load } }: { compared: Compared }) {
  if (!agreement && load.problem) return <LoadNotice load={load} empty />;
  return (
    <div role="status">
      {agreement ? (
        <Notice tone={agreement.enough ? "good" : "soft"} icon={iconFor(agreement)}>
          <p class="advice">{agreement.advice}</p>
        </Notice>
      ) : (
        <Notice tone="plain" icon="clock">
          <p class="advice">{t.teach.comparing}</p>
        </Notice>
      )}
    </div>
  );
}
