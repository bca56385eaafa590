// One line of text to type, under its name.
import type { Signal } from "@preact/signals";

interface Props {
  label: string;
  text: Signal<string>;
  maxLength: number;
  /** Says that Enter ends the typing. */
  done?: boolean;
}

export function TextField({ label, text, maxLength, done = false }: Props) {
  return (
    <label class="field">
      <span>{label}</span>
      <input
        value={text.value}
        maxLength={maxLength}
        autoComplete="off"
        enterKeyHint={done ? "done" : undefined}
        onInput={(event) => (text.value = event.currentTarget.value)}
      />
    </label>
  );
}
