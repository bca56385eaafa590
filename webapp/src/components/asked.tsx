// Something that cannot be undone by a press, so it asks first.
import { useSignal } from "@preact/signals";
import { useAction } from "../state/hooks";
import { Button } from "./button";
import type { IconName } from "./icon";
import { ProblemNotice } from "./notice";

interface Props {
  icon: IconName;
  press: string;
  question: string;
  yes: string;
  no: string;
  busy: string;
  why?: string | null;
  act: () => Promise<void>;
}

export function Asked({ icon, press, question, yes, no, busy, why = null, act }: Props) {
  const asking = useSignal(false);
  const action = useAction(async () => {
    await act();
    asking.value = false;
  });
  if (!asking.value) {
    return (
      <Button icon={icon} onPress={() => (asking.value = true)}>
        {press}
      </Button>
    );
  }
  return (
    <>
      {/* The answers are below what was pressed, perhaps out of sight. */}
      <p
        class="question"
        ref={(question) => question?.parentElement?.scrollIntoView({ block: "end" })}
      >
        {question}
      </p>
      <Button look="danger" icon={icon} why={why} busy={action.busy && busy} onPress={action.start}>
        {yes}
      </Button>
      <Button icon="back" onPress={() => (asking.value = false)}>
        {no}
      </Button>
      {action.problem && <ProblemNotice problem={action.problem} />}
    </>
  );
}
