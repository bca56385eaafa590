// One take: while it is being recorded, and afterwards to keep or discard it.
import { closeDemonstration } from "../../api/endpoints";
import type { Demonstration } from "../../api/types";
import { Button, ButtonLink } from "../../components/button";
import { LoadNotice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { demonstrations, loadDemonstration } from "../../state/entities";
import { useAction, useLoad } from "../../state/hooks";
import { go } from "../../state/navigation";
import { useWakeLock } from "../../state/wake-lock";
import { t } from "../../texts";
import { RecordingView } from "./recording-view";
import { ReviewView } from "./review-view";

export function TakePage({ task, take: id }: { task: string; take: string }) {
  const load = useLoad(() => loadDemonstration(id), id);
  const take = demonstrations.get(id);
  if (!take) {
    return (
      <Page title={t.teach.takes} back={{ page: "task", task }}>
        <LoadNotice load={load} empty />
      </Page>
    );
  }
  const open = take.state === "preparing" || take.state === "recording";
  return open ? <OpenTake key="open" take={take} /> : <ClosedTake key="closed" take={take} />;
}

function OpenTake({ take }: { take: Demonstration }) {
  useWakeLock(true);
  const stop = useAction(async () => demonstrations.put(await closeDemonstration(take.id, "stop")));
  return (
    <Page
      title={t.teach.take(take.take)}
      actions={
        <Button
          look="primary"
          icon="check"
          busy={stop.busy && t.teach.stoppingRecording}
          onPress={stop.start}
        >
          {take.state === "preparing" ? t.app.cancel : t.teach.stopRecording}
        </Button>
      }
    >
      {stop.problem && <ProblemNotice problem={stop.problem} />}
      <RecordingView take={take} />
    </Page>
  );
}

function ClosedTake({ take }: { take: Demonstration }) {
  const task = take.task_id;
  const useClose = (action: "keep" | "discard") =>
    useAction(async () => {
      demonstrations.put(await closeDemonstration(take.id, action));
      go({ page: "task", task }, true);
    });
  const keep = useClose("keep");
  const discard = useClose("discard");
  const undecided = take.state === "recorded" || take.state === "interrupted";
  const discardButton = (
    <Button icon="bin" busy={discard.busy && t.teach.discarding} onPress={discard.start}>
      {t.teach.discard}
    </Button>
  );
  const keepButton = (
    <Button
      look={undecided ? "primary" : "secondary"}
      icon="check"
      busy={keep.busy && t.teach.keeping}
      onPress={keep.start}
    >
      {undecided ? t.teach.keep : t.teach.keepAgain}
    </Button>
  );
  const back = (
    <ButtonLink to={{ page: "task", task }} look="primary" icon="back">
      {t.teach.backToTakes}
    </ButtonLink>
  );
  return (
    <Page
      title={t.teach.take(take.take)}
      back={{ page: "task", task }}
      actions={
        <>
          {take.state !== "discarded" && discardButton}
          {take.state !== "kept" && keepButton}
          {!undecided && back}
        </>
      }
    >
      {keep.problem && <ProblemNotice problem={keep.problem} />}
      {discard.problem && <ProblemNotice problem={discard.problem} />}
      <ReviewView take={take} />
    </Page>
  );
}
