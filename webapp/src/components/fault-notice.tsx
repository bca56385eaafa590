// A fault of the robot on whatever screen is shown: what happened, what to do, and the word of a
// person that it was done.
import { useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { resetRobot } from "../api/endpoints";
import { useAction } from "../state/hooks";
import { robot } from "../state/live";
import { robotId } from "../state/robots";
import { t } from "../texts";
import { Button } from "./button";
import { Icon } from "./icon";
import { ProblemNotice } from "./notice";

export function FaultNotice() {
  const text = useComputed(() => JSON.stringify(robot.value?.fault ?? null));
  const faulted = useComputed(() => robot.value?.state === "faulted");
  const reset = useAction(async () => {
    await resetRobot(robotId.peek());
  });
  const place = useRef<HTMLElement>(null);
  // Whatever is being read on the screen, a fault comes first.
  useEffect(() => place.current?.scrollIntoView(), [faulted.value]);
  const fault = JSON.parse(text.value) as { message: string; advice: string } | null;
  if (!faulted.value || fault === null) return null;
  return (
    <section ref={place} class="fault" role="alert">
      <Icon name="alert" />
      <dl class="what-to-do">
        <dt>{t.robot.happened}</dt>
        <dd>{fault.message}</dd>
        <dt>{t.robot.todo}</dt>
        <dd>{fault.advice}</dd>
      </dl>
      <Button icon="check" busy={reset.busy && t.robot.acknowledging} onPress={reset.start}>
        {t.robot.acknowledge}
      </Button>
      {reset.problem && <ProblemNotice problem={reset.problem} />}
    </section>
  );
}
