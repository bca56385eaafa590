// One of a few, as big cards. Radio buttons underneath, so keyboard and screen reader work.
import { useId } from "preact/hooks";

export interface Option<T extends string> {
  value: T;
  name: string;
  detail?: string;
}

interface Props<T extends string> {
  legend: string;
  options: readonly Option<T>[];
  value: T;
  onChoose: (value: T) => void;
  /** Side by side instead of one below the other. */
  row?: boolean;
}

export function Choice<T extends string>({ legend, options, value, onChoose, row }: Props<T>) {
  const group = useId();
  return (
    <fieldset class={row ? "choice choice-row" : "choice"}>
      <legend>{legend}</legend>
      <div class="choice-options">
        {options.map((option) => (
          <label key={option.value} class="choice-card">
            <input
              type="radio"
              name={group}
              value={option.value}
              checked={option.value === value}
              onChange={() => onChoose(option.value)}
            />
            <span class="choice-text">
              <strong>{option.name}</strong>
              {option.detail && <span>{option.detail}</span>}
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
