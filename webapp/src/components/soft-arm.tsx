// Making the arm soft without recording, to bring it back by hand.
import { useComputed } from "@preact/signals";
import { LiveArm } from "../arm3d/live-arm";
import { returnVirtualHand, setLeadThrough } from "../api/endpoints";
import { newSeed } from "../api/ids";
import { handScript } from "../state/hand-script";
import { useAction } from "../state/hooks";
import { connection, isVirtual, robot, robotState } from "../state/live";
import { whyNotReady } from "../state/robot-status";
import { robotId } from "../state/robots";
import { t } from "../texts";
import { Button } from "./button";
import { Notice, ProblemNotice } from "./notice";

export function SoftArm() {
  const soft = robotState.value === "guiding";
  const why = useComputed(() => whyNotReady(robot.value, connection.value, true));
  const handBusy = useComputed(() => robot.value?.hand === "returning");
  const toggle = useAction(async () => {
    await setLeadThrough(robotId.peek(), !soft);
  });
  const bringBack = useAction(async () => {
    const script = handScript();
    if (script) await returnVirtualHand(robotId.peek(), script, newSeed());
  });
  const busy = soft ? t.robot.soft.turningOff : t.robot.soft.turningOn;
  return (
    <section class="card">
      <h2>{t.robot.soft.title}</h2>
      {soft ? (
        <Notice tone="soft" icon="hand">
          {t.robot.soft.isSoft}
        </Notice>
      ) : (
        <p>{t.robot.soft.explain}</p>
      )}
      <Button icon="hand" why={why.value} busy={toggle.busy && busy} onPress={toggle.start}>
        {soft ? t.robot.soft.off : t.robot.soft.on}
      </Button>
      {soft && <LiveArm />}
      {soft && isVirtual.value && handScript() !== null && (
        <Button
          icon="again"
          busy={(bringBack.busy || handBusy.value) && t.robot.soft.handMoving}
          onPress={bringBack.start}
        >
          {t.robot.soft.handBack}
        </Button>
      )}
      {toggle.problem && <ProblemNotice problem={toggle.problem} />}
      {bringBack.problem && <ProblemNotice problem={bringBack.problem} />}
    </section>
  );
}
