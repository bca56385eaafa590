// Whether the arm moves while the button is held, which is the rule, or by itself.
import { Choice } from "../../components/choice";
import { Notice } from "../../components/notice";
import { robot } from "../../state/live";
import { change, setupOf, type RunMode } from "../../state/run-setup";
import { t } from "../../texts";

export function RunModeChoice({ task }: { task: string }) {
  if (!robot.value?.continuous_run) {
    return (
      <Notice tone="plain" icon="info">
        <p>{t.hold.onlyHeld}</p>
      </Notice>
    );
  }
  return (
    <Choice<RunMode>
      legend={t.hold.mode}
      options={(["held", "alone"] as const).map((mode) => ({
        value: mode,
        ...t.hold.modes[mode],
      }))}
      value={setupOf(task).mode}
      onChoose={(mode) => change(task, { mode })}
    />
  );
}
