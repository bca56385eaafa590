// The seconds before a recording: enough to take the arm in hand, and on the way to another take to
// bring it back first.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { LiveArm } from "../../arm3d/live-arm";
import { Button } from "../../components/button";
import { Page } from "../../components/page";
import { isVirtual } from "../../state/live";
import { t } from "../../texts";

export interface Counter {
  /** Null while nothing is counted. */
  left: number | null;
  start: (from: number) => void;
  cancel: () => void;
  add: (seconds: number) => void;
}

/** Counts seconds down and then calls `done`. */
export function useCountIn(done: () => void): Counter {
  const left = useSignal<number | null>(null);
  useEffect(() => {
    if (left.value === null) return;
    const next = setTimeout(() => {
      if (left.value === 1) {
        left.value = null;
        done();
      } else if (left.value !== null) {
        left.value -= 1;
      }
    }, 1000);
    return () => clearTimeout(next);
  }, [left.value]);
  return {
    left: left.value,
    start: (from) => (left.value = from),
    cancel: () => (left.value = null),
    add: (seconds) => {
      if (left.value !== null) left.value += seconds;
    },
  };
}

export function CountIn({ count, onCancel }: { count: number; onCancel: () => void }) {
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

interface BringBackProps {
  count: number;
  onCancel: () => void;
  onMore: () => void;
  onNow: () => void;
}

/** Before another take that a person leads: the arm is soft already. */
export function BringBack({ count, onCancel, onMore, onNow }: BringBackProps) {
  return (
    <Page
      title={t.teach.recordTitle}
      actions={
        <>
          <div class="actions-row">
            <Button icon="cross" onPress={onCancel}>
              {t.app.cancel}
            </Button>
            <Button icon="clock" onPress={onMore}>
              {t.teaching.next.more}
            </Button>
          </div>
          <Button look="primary" icon="record" onPress={onNow}>
            {t.teaching.next.now}
          </Button>
        </>
      }
    >
      <div class="count-in bring-back">
        <p>{t.teaching.next.bringBack}</p>
        <div role="status">
          <p>{t.teaching.next.begins}</p>
          <p class="count">{count}</p>
        </div>
      </div>
      {isVirtual.value && <LiveArm />}
    </Page>
  );
}
