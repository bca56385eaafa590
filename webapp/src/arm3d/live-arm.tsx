// The arm as it stands now, following its live samples; and for a virtual arm that is soft, a ball
// at its tool to lead it by, with buttons for the same.
import { signal, useComputed, useSignal, useSignalEffect, type Signal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { Notice } from "../components/notice";
import { dragLost, dragRefused } from "../state/arm-drag";
import { armDrag, connection, robot } from "../state/live";
import { controlledByOther } from "../state/robot-status";
import { t } from "../texts";
import { ArmView } from "./arm-view";
import type { Grip } from "./gestures";
import { LivePose, type Pose } from "./poses";
import { WORKPLACE_MM } from "./room";
import type { Stage } from "./stage";
import { SteerButtons } from "./steer-buttons";

/** Who has once moved the ball needs no words any more. */
const led = signal(false);

const GRIP: Grip = {
  begin: () => {
    led.value = true;
    armDrag.begin();
  },
  move: (toMm) => armDrag.move({ tool_mm: toMm }),
  end: () => armDrag.end(),
};

export function LiveArm({ fill = false }: { fill?: boolean }) {
  const joints = useLivePose();
  const stage = useSignal<Stage | null>(null);
  const canLead = useComputed(() => {
    const view = robot.value;
    // The virtual hand leads while a finger does: it is the finger's own.
    const free = ["idle", "leading"].includes(view?.hand ?? "idle");
    const soft = view?.kind === "virtual" && view.state === "guiding" && free;
    return soft && connection.value === "live" && controlledByOther(view) === null;
  });
  const lead = canLead.value;
  // Whatever ends the leading: nobody holds the arm any more.
  useEffect(() => (lead ? () => armDrag.end() : undefined), [lead]);
  return (
    <ArmView
      joints={joints}
      room={WORKPLACE_MM}
      label={t.arm3d.labels.live}
      grip={lead ? GRIP : null}
      fill={fill}
      hint={lead && !led.value ? t.arm3d.drag.hint : null}
      onStage={(made) => (stage.value = made)}
    >
      <Refusal />
      {lead && stage.value && <SteerButtons stage={stage.value} />}
    </ArmView>
  );
}

function Refusal() {
  const refused = dragRefused.value;
  if (refused) {
    return (
      <Notice tone="soft" icon="alert">
        <p>{refused.detail}</p>
        <p>{refused.advice}</p>
      </Notice>
    );
  }
  return dragLost.value ? (
    <Notice tone="plain" icon="info">
      <p>{t.arm3d.drag.lost}</p>
    </Notice>
  ) : null;
}

/** The pose between the last samples, a moment late; at rest nothing runs. */
function useLivePose(): Signal<Pose | null> {
  const shown = useSignal<Pose | null>(null);
  const live = useMemo(() => new LivePose(), []);
  const running = useMemo(() => ({ frame: 0 }), []);
  const step = () => {
    running.frame = 0;
    const nowS = performance.now() / 1000;
    const pose = live.at(nowS);
    if (pose && !same(pose, shown.peek())) shown.value = pose;
    if (!live.settled(nowS)) running.frame = requestAnimationFrame(step);
  };
  useSignalEffect(() => {
    const view = robot.value;
    if (!view?.joints_deg) return;
    live.push((performance.now() - view.age_ms) / 1000, view.joints_deg);
    if (running.frame === 0) running.frame = requestAnimationFrame(step);
  });
  useEffect(() => () => cancelAnimationFrame(running.frame), []);
  return shown;
}

/** Below what a picture shows: a standing arm is not drawn anew for the last digit. */
const same = (a: Pose, b: Pose | null) =>
  b !== null && a.every((angle, joint) => Math.abs(angle - (b[joint] ?? 0)) < 0.005);
