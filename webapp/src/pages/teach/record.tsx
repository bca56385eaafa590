// Before a recording: what will happen, and the count-in.
import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { setLeadThrough, startDemonstration, type NewDemonstration } from "../../api/endpoints";
import { newId, newSeed } from "../../api/ids";
import { Button } from "../../components/button";
import { Choice } from "../../components/choice";
import { ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { SoftArm } from "../../components/soft-arm";
import { demonstrations } from "../../state/entities";
import { handScript, leader, type Leader } from "../../state/hand-script";
import { useAction } from "../../state/hooks";
import { connection, isVirtual, robot, robotState } from "../../state/live";
import { go } from "../../state/navigation";
import { whyNotReady } from "../../state/robot-status";
import { robotId } from "../../state/robots";
import { t } from "../../texts";

const COUNT_FROM = 3;
const LEADERS: readonly Leader[] = ["self", "f1", "f2", "f3"];

export function RecordPage({ task }: { task: string }) {
  const count = useSignal<number | null>(null);
  // One id for all trials of one recording: pressing again on bad Wi-Fi begins it once.
  const id = useMemo(() => newId(), []);
  const record = useAction(async () => {
    if (robotState.peek() === "guiding") await setLeadThrough(robotId.peek(), false);
    const body: NewDemonstration = { id, robot: robotId.peek() };
    const script = isVirtual.peek() ? handScript() : null;
    if (script) Object.assign(body, { virtual_hand: script, seed: newSeed() });
    const take = await startDemonstration(task, body);
    demonstrations.put(take);
    go({ page: "take", task, take: take.id }, true);
  });
  useEffect(() => {
    if (count.value === null) return;
    const next = setTimeout(() => {
      if (count.value === 1) {
        count.value = null;
        record.start();
      } else if (count.value !== null) {
        count.value -= 1;
      }
    }, 1000);
    return () => clearTimeout(next);
  }, [count.value]);

  if (count.value !== null)
    return <CountIn count={count.value} onCancel={() => (count.value = null)} />;
  return (
    <Page
      title={t.teach.recordTitle}
      back={{ page: "task", task }}
      actions={<RecordButton busy={record.busy} onPress={() => (count.value = COUNT_FROM)} />}
    >
      {record.problem && <ProblemNotice problem={record.problem} />}
      <ol class="steps">
        {steps().map((step) => (
          <li key={step}>{step}</li>
        ))}
      </ol>
      {isVirtual.value && (
        <Choice
          legend={t.arm3d.lead.who}
          options={LEADERS.map((value) => ({
            value,
            ...(value === "self" ? t.arm3d.lead : t.teach.hands[value]),
          }))}
          value={leader.value}
          onChoose={(chosen) => (leader.value = chosen)}
        />
      )}
      <SoftArm />
    </Page>
  );
}

function steps(): readonly string[] {
  if (!isVirtual.value) return t.teach.steps;
  return handScript() === null ? t.arm3d.lead.steps : t.teach.stepsVirtual;
}

function RecordButton({ busy, onPress }: { busy: boolean; onPress: () => void }) {
  const why = useComputed(() => whyNotReady(robot.value, connection.value, true));
  return (
    <Button
      look="primary"
      icon="record"
      why={busy ? null : why.value}
      busy={busy && t.teach.startingRecording}
      onPress={onPress}
    >
      {t.teach.startRecording}
    </Button>
  );
}

function CountIn({ count, onCancel }: { count: number; onCancel: () => void }) {
  return (
    <Page
      title={t.teach.recordTitle}
      actions={
        <Button icon="cross" onPress={onCancel}>
          {t.app.cancel}
        </Button>
      }
    >
      <div class="count-in" role="status">
        <p>{t.teach.countIn}</p>
        <p class="count">{count}</p>
        <p>{t.teach.countHold}</p>
      </div>
    </Page>
  );
}
