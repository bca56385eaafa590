// The first screen of a phone that the server does not know yet.
import { useSignal } from "@preact/signals";
import type { Problem } from "../api/problem";
import { Button } from "../components/button";
import { ProblemNotice } from "../components/notice";
import { Page } from "../components/page";
import { useAction } from "../state/hooks";
import { pair } from "../state/session";
import { t } from "../texts";

export function PairingPage({ problem }: { problem: Problem | null }) {
  const code = useSignal("");
  const action = useAction(() => pair(code.value.trim()));
  const shown = action.problem ?? (action.busy ? null : problem);
  return (
    <Page
      title={t.pairing.title}
      first
      actions={
        <Button
          look="primary"
          icon="next"
          busy={action.busy && t.pairing.connecting}
          onPress={action.start}
        >
          {t.pairing.connect}
        </Button>
      }
    >
      <p>{t.pairing.explain}</p>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          action.start();
        }}
      >
        <label class="field">
          <span>{t.pairing.code}</span>
          <input
            class="code"
            inputMode="numeric"
            autoComplete="one-time-code"
            value={code.value}
            onInput={(event) => (code.value = event.currentTarget.value)}
          />
        </label>
      </form>
      {shown && <ProblemNotice problem={shown} />}
    </Page>
  );
}
