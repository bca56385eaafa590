// The signals of a time line in words: what is worked when.
import type { SignalMark } from "../api/types";
import { duration } from "../format/numbers";
import { robot } from "../state/live";
import { t } from "../texts";

interface Props {
  title: string;
  marks: SignalMark[];
}

export function SignalTimes({ title, marks }: Props) {
  if (marks.length === 0) return null;
  return (
    <section class="signal-times">
      <h2>{title}</h2>
      <ol>
        {marks.map((mark) => (
          <li key={`${mark.name} ${mark.at_s} ${mark.on}`}>
            <strong>{words(mark)}</strong> {t.signals.at(duration(mark.at_s))}
          </li>
        ))}
      </ol>
    </section>
  );
}

/** In the words of this cell; a signal from elsewhere keeps its own name. */
function words({ name, on }: SignalMark): string {
  const known = robot.value?.signals.find((signal) => signal.name === name);
  return known
    ? t.signals.press(known.label, on ? known.on : known.off)
    : t.signals.press(name, on ? "1" : "0");
}
