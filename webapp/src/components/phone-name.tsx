// What other people read when this phone controls a robot.
import { useSignal } from "@preact/signals";
import { namePhone, phoneName } from "../state/phone";
import { t } from "../texts";
import { Button } from "./button";
import { TextField } from "./text-field";

export function PhoneName() {
  const text = useSignal(phoneName.peek());
  const saved = text.value.trim() === phoneName.value;
  return (
    <section class="card">
      <TextField label={t.control.phoneName} text={text} maxLength={40} />
      <p class="hint">{t.control.phoneNameHint}</p>
      {!saved && text.value.trim() !== "" && (
        <Button icon="check" onPress={() => namePhone(text.peek().trim())}>
          {t.control.save}
        </Button>
      )}
    </section>
  );
}
