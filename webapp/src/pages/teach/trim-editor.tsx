// Cutting the ends of a take: proposed in one press, or by hand with handles and small steps. The
// plots veil what is cut away; nothing of it is lost.
import { useSignal, type Signal } from "@preact/signals";
import { deleteTrim, putTrim, suggestTrim } from "../../api/endpoints";
import type { Demonstration, Trajectory, Trim } from "../../api/types";
import { Button } from "../../components/button";
import { Notice, ProblemNotice } from "../../components/notice";
import { duration, fixed } from "../../format/numbers";
import { CutOverview } from "../../plots/cut-overview";
import { demonstrations } from "../../state/entities";
import { useAction, useLoad } from "../../state/hooks";
import { t } from "../../texts";

const STEP_S = 0.1;
/** The server refuses less than a second; a step more is asked for here. */
const LEAST_S = 1.1;

/** The stretch that is used now. */
export function usedOf(take: Demonstration): Trim {
  return take.trim ?? { from_s: 0, to_s: take.duration_s };
}

/** One end moved to a time, within the take and away from the other end. */
export function moved(span: Trim, end: keyof Trim, toS: number, lengthS: number): Trim {
  const round = (value: number) => Math.round(value * 10) / 10;
  if (end === "from_s") {
    const latest = Math.max(0, span.to_s - LEAST_S);
    return { ...span, from_s: Math.min(Math.max(0, round(toS)), latest) };
  }
  const earliest = Math.min(lengthS, span.from_s + LEAST_S);
  // The last step reaches the very end, wherever that lies.
  const wanted = toS >= lengthS - STEP_S / 2 ? lengthS : round(toS);
  return { ...span, to_s: Math.max(Math.min(wanted, lengthS), earliest) };
}

interface Props {
  take: Demonstration;
  /** All of it. */
  trajectory: Trajectory;
  span: Signal<Trim>;
}

export function TrimEditor({ take, trajectory, span }: Props) {
  const proposal = useSignal<Trim | null>(null);
  useLoad(async () => {
    proposal.value = (await suggestTrim(take.id)).trim ?? null;
  }, take.id);
  const put = (changed: Demonstration) => {
    demonstrations.put(changed);
    span.value = usedOf(changed);
  };
  const save = useAction(async () => put(await putTrim(take.id, span.peek())));
  const accept = useAction(async () => {
    if (proposal.value) put(await putTrim(take.id, proposal.value));
  });
  const restore = useAction(async () => put(await deleteTrim(take.id)));
  const saved = usedOf(take);
  const same = saved.from_s === span.value.from_s && saved.to_s === span.value.to_s;
  const problem = save.problem ?? accept.problem ?? restore.problem;
  return (
    <section class="card" aria-label={t.teaching.trim.title}>
      {problem && <ProblemNotice problem={problem} />}
      {take.trim ? (
        <>
          <Notice tone="plain" icon="info">
            <p>
              {t.teaching.trim.isCut(
                duration(take.trim.from_s),
                duration(take.duration_s - take.trim.to_s),
              )}
            </p>
          </Notice>
          <Button
            icon="undo"
            busy={restore.busy && t.teaching.trim.restoring}
            onPress={restore.start}
          >
            {t.teaching.trim.whole}
          </Button>
        </>
      ) : (
        proposal.value && (
          <>
            <p>{standing(proposal.value, take.duration_s)}</p>
            <Button icon="cut" busy={accept.busy && t.teaching.trim.saving} onPress={accept.start}>
              {t.teaching.trim.accept}
            </Button>
          </>
        )
      )}
      <details>
        <summary>{t.teaching.trim.title}</summary>
        <div class="trim">
          <p>{t.teaching.trim.explain}</p>
          <CutOverview trajectory={trajectory} span={span} />
          <End span={span} end="from_s" lengthS={take.duration_s} />
          <End span={span} end="to_s" lengthS={take.duration_s} />
          <Button
            icon="cut"
            why={same && !save.busy ? t.teaching.trim.unchanged : null}
            busy={save.busy && t.teaching.trim.saving}
            onPress={save.start}
          >
            {t.teaching.trim.save}
          </Button>
        </div>
      </details>
    </section>
  );
}

/** How long the arm stands still before and after what would be left. */
function standing({ from_s, to_s }: Trim, lengthS: number): string {
  const [before, after] = [duration(from_s), duration(lengthS - to_s)];
  if (from_s === 0) return t.teaching.trim.standsLast(after);
  return to_s >= lengthS
    ? t.teaching.trim.standsFirst(before)
    : t.teaching.trim.stands(before, after);
}

interface EndProps {
  span: Signal<Trim>;
  end: keyof Trim;
  lengthS: number;
}

function End({ span, end, lengthS }: EndProps) {
  const name = end === "from_s" ? t.teaching.trim.begins : t.teaching.trim.ends;
  const atS = span.value[end];
  const move = (toS: number) => (span.value = moved(span.peek(), end, toS, lengthS));
  const step = (byS: number) => {
    const words = t.units.seconds(`${byS > 0 ? "+" : ""}${fixed(byS, 1)}`);
    return (
      <button
        type="button"
        class="button button-secondary"
        aria-label={t.teaching.trim.move(name, words)}
        onClick={() => move(span.peek()[end] + byS)}
      >
        {words}
      </button>
    );
  };
  return (
    <div class="trim-end">
      <p>
        <span>{name}</span>
        <strong>{duration(atS)}</strong>
      </p>
      <div class="trim-steps">
        {step(-STEP_S)}
        <input
          type="range"
          aria-label={name}
          aria-valuetext={duration(atS)}
          min={0}
          max={lengthS}
          step="any"
          value={atS}
          onInput={(event) => move(event.currentTarget.valueAsNumber)}
        />
        {step(STEP_S)}
      </div>
    </div>
  );
}
