// Before a recording: what will happen, and the count-in.
import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
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
import { isAtOnce } from "../../state/next-take";
import { whyNotReady } from "../../state/robot-status";
import { robotId } from "../../state/robots";
import { useCountInTicks } from "../../state/signals-to-hand";
import { useWakeLock } from "../../state/wake-lock";
import { t } from "../../texts";
import { BringBack, CountIn, useCountIn } from "./count-in";

const COUNT_FROM = 3;
/** Seconds to bring an arm back by hand, and by a finger in its picture; and how many more a press
 *  gives. */
const BRING_BACK_FROM = 10;
const DRAG_BACK_FROM = 20;
const MORE = 10;
const LEADERS: readonly Leader[] = ["self", "f1", "f2", "f3"];

export function RecordPage({ task }: { task: string }) {
  // One id for all trials of one recording: pressing again on bad Wi-Fi begins it once.
  const id = useMemo(() => newId(), []);
  /** Whether this page made the arm soft, to be brought back. */
  const softened = useRef(false);
  const record = useAction(async () => {
    // An arm that is in the hand stays there: the recording takes it over as it is.
    const taken = softened.current;
    softened.current = false;
    if (!taken && robotState.peek() === "guiding") await setLeadThrough(robotId.peek(), false);
    const body: NewDemonstration = { id, robot: robotId.peek() };
    const script = isVirtual.peek() ? handScript() : null;
    if (script) Object.assign(body, { virtual_hand: script, seed: newSeed() });
    const take = await startDemonstration(task, body);
    demonstrations.put(take);
    go({ page: "take", task, take: take.id }, true);
  });
  const counter = useCountIn(record.start);
  const cancel = () => {
    counter.cancel();
    if (softened.current) void setLeadThrough(robotId.peek(), false).catch(() => undefined);
    softened.current = false;
  };
  useEffect(() => cancel, []);
  const next = useNextTake(task, async () => {
    // The virtual hand brings the arm back by itself.
    const byScript = isVirtual.peek() && handScript() !== null;
    if (!byScript) {
      await setLeadThrough(robotId.peek(), true);
      softened.current = true;
    }
    const bringBack = isVirtual.peek() ? DRAG_BACK_FROM : BRING_BACK_FROM;
    counter.start(byScript ? COUNT_FROM : bringBack);
  });

  useWakeLock(counter.left !== null || record.busy);
  useCountInTicks(counter.left);
  if (counter.left !== null && softened.current)
    return (
      <BringBack
        count={counter.left}
        onCancel={cancel}
        onMore={() => counter.add(MORE)}
        onNow={() => {
          counter.cancel();
          record.start();
        }}
      />
    );
  if (counter.left !== null) return <CountIn count={counter.left} onCancel={cancel} />;
  if (next.waits) return <Waiting busy={next.busy} onCancel={next.cancel} />;
  const problem = record.problem ?? next.problem;
  return (
    <Page
      title={t.teach.recordTitle}
      back={{ page: "task", task }}
      actions={<RecordButton busy={record.busy} onPress={() => counter.start(COUNT_FROM)} />}
    >
      {problem && <ProblemNotice problem={problem} />}
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

/** When another take was asked for on the page before: begins it as soon as the arm is ready. */
function useNextTake(task: string, begin: () => Promise<void>) {
  const waits = useSignal(useMemo(() => isAtOnce(task), []));
  const ready = useComputed(() => whyNotReady(robot.value, connection.value, true) === null);
  const start = useAction(async () => {
    try {
      await begin();
    } finally {
      waits.value = false;
    }
  });
  useEffect(() => {
    if (waits.peek() && ready.value) start.start();
  }, [ready.value]);
  return { ...start, waits: waits.value, cancel: () => (waits.value = false) };
}

/** The arm is not ready yet; why, and the way out. */
function Waiting({ busy, onCancel }: { busy: boolean; onCancel: () => void }) {
  const why = useComputed(() => whyNotReady(robot.value, connection.value, true));
  return (
    <Page
      title={t.teach.recordTitle}
      actions={
        <Button icon="cross" why={busy ? t.teaching.next.softening : null} onPress={onCancel}>
          {t.app.cancel}
        </Button>
      }
    >
      <p class="loading" role="status">
        <span class="spinner" aria-hidden="true" />
        {t.teaching.next.wait}
      </p>
      {why.value !== null && <p class="why">{why.value}</p>}
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
