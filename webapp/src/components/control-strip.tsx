// Said under the robot's state when more than one phone wants it: who controls it, and the ways to
// ask for it, to give it away and to keep it.
import { useComputed, useSignal } from "@preact/signals";
import { changeControl } from "../api/endpoints";
import type { ControlView } from "../api/types";
import { useAction } from "../state/hooks";
import { connection, robot } from "../state/live";
import { phoneId } from "../state/phone";
import { robotId } from "../state/robots";
import { t } from "../texts";
import { Button } from "./button";
import { ProblemNotice } from "./notice";

export function ControlStrip() {
  const text = useComputed(() => JSON.stringify(robot.value?.control ?? null));
  const control = JSON.parse(text.value) as ControlView | null;
  if (control === null || connection.value !== "live") return null;
  if (control.phone.id !== phoneId) return <Other control={control} />;
  return control.asked_by ? <Asked by={control.asked_by.name} /> : null;
}

function Other({ control }: { control: ControlView }) {
  const ask = useAction(() => changeControl(robotId.peek(), "ask").then(() => undefined));
  const waits = control.asked_by?.id === phoneId;
  return (
    <section class="control-strip" aria-label={t.control.title}>
      <p role="status">{waits ? t.control.asked : t.control.other(control.phone.name)}</p>
      {!waits && (
        <Button icon="hand" busy={ask.busy && t.control.asking} onPress={ask.start}>
          {t.control.ask}
        </Button>
      )}
      {ask.problem && <ProblemNotice problem={ask.problem} />}
    </section>
  );
}

function Asked({ by }: { by: string }) {
  const wish = useSignal<"give" | "keep">("keep");
  const answer = useAction(() => changeControl(robotId.peek(), wish.peek()).then(() => undefined));
  const press = (action: "give" | "keep") => () => {
    wish.value = action;
    answer.start();
  };
  return (
    <section class="control-strip" aria-label={t.control.title}>
      <p role="alert">{t.control.wants(by)}</p>
      <div class="control-answers">
        <Button icon="check" onPress={press("give")}>
          {t.control.give}
        </Button>
        <Button icon="cross" onPress={press("keep")}>
          {t.control.keep}
        </Button>
      </div>
      {answer.problem && <ProblemNotice problem={answer.problem} />}
    </section>
  );
}
