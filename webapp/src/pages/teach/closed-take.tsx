// A take that is over: to keep or discard it, and what comes next in one press.
import type { Demonstration } from "../../api/types";
import { Button, ButtonLink } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { useAgreement } from "../../state/agreement";
import { decide } from "../../state/decisions";
import { demonstrations } from "../../state/entities";
import { useAction, type Action } from "../../state/hooks";
import { go } from "../../state/navigation";
import { recordAtOnce } from "../../state/next-take";
import { train } from "../../state/training";
import { t } from "../../texts";
import { ReviewView } from "./review-view";

export function ClosedTake({ take }: { take: Demonstration }) {
  const task = take.task_id;
  const useDecision = (action: "keep" | "discard", then: () => void | Promise<void>) =>
    useAction(async () => {
      await decide(take, action);
      await then();
    });
  const toTask = () => go({ page: "task", task }, true);
  const keep = useDecision("keep", toTask);
  const discard = useDecision("discard", toTask);
  const another = useDecision("keep", () => {
    recordAtOnce(task);
    go({ page: "record", task }, true);
  });
  const keepTrain = useDecision("keep", () => train(task, true));
  const compared = useAgreement(task);
  const undecided = take.state === "recorded" || take.state === "interrupted";
  const problem = keep.problem ?? discard.problem ?? another.problem ?? keepTrain.problem;
  const keepButton = (
    <Button icon="check" busy={keep.busy && t.teach.keeping} onPress={keep.start}>
      {undecided ? t.teach.keep : t.teach.keepAgain}
    </Button>
  );
  return (
    <Page
      title={t.teach.take(take.take)}
      back={{ page: "task", task }}
      actions={
        <>
          <div class="actions-row">
            {take.state !== "discarded" && <DiscardButton discard={discard} />}
            {take.state !== "kept" && keepButton}
          </div>
          {undecided ? (
            <OnwardButtons
              {...{ another, keepTrain }}
              isFirst={!hasOtherKept(take)}
              enough={compared.agreement?.enough === true}
            />
          ) : (
            <ButtonLink to={{ page: "task", task }} look="primary" icon="back">
              {t.teach.backToTakes}
            </ButtonLink>
          )}
        </>
      }
    >
      {problem && <ProblemNotice problem={problem} />}
      <ReviewView take={take} compared={compared} />
    </Page>
  );
}

/** Whether another take of the task is kept already. */
function hasOtherKept({ id, task_id }: Demonstration): boolean {
  const other = (take: Demonstration) =>
    take.task_id === task_id && take.id !== id && take.state === "kept";
  return demonstrations.where(other).length > 0;
}

function DiscardButton({ discard }: { discard: Action }) {
  return (
    <Button icon="bin" busy={discard.busy && t.teach.discarding} onPress={discard.start}>
      {t.teach.discard}
    </Button>
  );
}

interface OnwardProps {
  another: Action;
  keepTrain: Action;
  isFirst: boolean;
  enough: boolean;
}

/** Only the looks follow the advice: a button must not move away under a finger. */
function OnwardButtons({ another, keepTrain, isFirst, enough }: OnwardProps) {
  return (
    <div class="actions-row">
      <Button
        look={enough ? "secondary" : "primary"}
        icon="record"
        busy={another.busy && t.teach.keeping}
        onPress={another.start}
      >
        {t.teaching.keepAnother}
      </Button>
      {!isFirst && (
        <Button
          look={enough ? "primary" : "secondary"}
          icon="train"
          busy={keepTrain.busy && t.teach.trainStarting}
          onPress={keepTrain.start}
        >
          {t.teaching.keepTrain}
        </Button>
      )}
    </div>
  );
}
