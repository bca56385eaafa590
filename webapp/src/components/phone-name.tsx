// What other people read when this phone controls a robot.
import { useSignal } from "@preact/signals";
import { namePhone, phoneName } from "../state/phone";
import { t } from "../texts";
import { Button } from "./button";

export function PhoneName() {
  const text = useSignal(phoneName.peek());
  const saved = text.value.trim() === phoneName.value;
  return (
    <section class="card">
      <label class="field">
        <span>{t.control.phoneName}</span>
        <input
          value={text.value}
          maxLength={40}
          autoComplete="off"
          onInput={(event) => (text.value = event.currentTarget.value)}
        />
      </label>
      <p class="hint">{t.control.phoneNameHint}</p>
      {!saved && text.value.trim() !== "" && (
        <Button icon="check" onPress={() => namePhone(text.peek().trim())}>
          {t.control.save}
        </Button>
      )}
    </section>
  );
}
