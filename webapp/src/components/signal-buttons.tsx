// One big button for each signal that may be worked: it says how the signal stands, and pressing
// it does the opposite.
import { setSignal } from "../api/endpoints";
import type { RobotView, SignalAnswer } from "../api/types";
import type { ConnectionState } from "../live/connection";
import { useAction } from "../state/hooks";
import { connection, robot } from "../state/live";
import { controlledByOther } from "../state/robot-status";
import { t } from "../texts";
import { Button } from "./button";
import { ProblemNotice } from "./notice";

export function SignalButtons() {
  const view = robot.value;
  if (!view || view.signals.length === 0) return null;
  return (
    <section class="signal-buttons" aria-label={t.signals.group}>
      {view.signals.map((signal) => (
        <SignalButton
          key={signal.name}
          robot={view.id}
          signal={signal}
          why={whyNot(signal, view, connection.value)}
        />
      ))}
    </section>
  );
}

interface ButtonOf {
  robot: string;
  signal: SignalAnswer;
  why: string | null;
}

function SignalButton({ robot: id, signal, why }: ButtonOf) {
  const on = !signal.is_on;
  const press = useAction(async () => {
    await setSignal(id, encodeURIComponent(signal.name), on);
  });
  return (
    <>
      {press.problem && <ProblemNotice problem={press.problem} />}
      {!why && (
        <p role="status">{t.signals.stands(signal.label, signal.is_on ? signal.on : signal.off)}</p>
      )}
      <Button
        why={press.busy ? null : why}
        busy={press.busy && t.signals.setting(signal.label)}
        onPress={press.start}
      >
        {t.signals.press(signal.label, on ? signal.on : signal.off)}
      </Button>
    </>
  );
}

/** Why it cannot be worked now; null when it can. */
export function whyNot(
  signal: SignalAnswer,
  view: RobotView,
  connected: ConnectionState,
): string | null {
  if (connected !== "live") return t.robot.why.offline;
  const other = controlledByOther(view);
  if (other !== null) return t.control.other(other);
  if (view.state === "disconnected") return t.robot.why.disconnected;
  if (view.state === "reproducing") return t.signals.notWhileMoving;
  return typeof signal.is_on === "boolean" ? null : t.signals.unknown(signal.label);
}
