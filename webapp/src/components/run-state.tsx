// How a motion ended and what a person said of it, each with a sign, a word and a colour.
import type { Reproduction } from "../api/types";
import { t } from "../texts";
import { Icon, type IconName } from "./icon";

const LOOKS: Record<Reproduction["state"], [tone: string, icon: IconName]> = {
  running: ["moving", "move"],
  succeeded: ["good", "check"],
  stopped: ["soft", "stop"],
  failed: ["bad", "alert"],
};

export function RunState({ state }: { state: Reproduction["state"] }) {
  const [tone, icon] = LOOKS[state];
  return (
    <span class={`state tone-${tone}`}>
      <Icon name={icon} />
      {t.run.states[state]}
    </span>
  );
}

export function Worked({ worked }: { worked: boolean | null | undefined }) {
  if (worked == null) return <span class="hint">{t.dashboard.unsaid}</span>;
  return (
    <span class={`state tone-${worked ? "good" : "bad"}`}>
      <Icon name={worked ? "check" : "cross"} />
      {worked ? t.dashboard.yes : t.dashboard.no}
    </span>
  );
}
