// Whether the motion did its work, as the person at the arm saw it: one tap, which may be changed.
import { useSignal } from "@preact/signals";
import { setOutcome, takeBackOutcome } from "../../api/endpoints";
import type { Reproduction } from "../../api/types";
import { Button } from "../../components/button";
import { Icon } from "../../components/icon";
import { ProblemNotice } from "../../components/notice";
import { reproductions } from "../../state/entities";
import { useAction } from "../../state/hooks";
import { t } from "../../texts";
import { TextField } from "../../components/text-field";

export function OutcomeQuestion({ motion }: { motion: Reproduction }) {
  const wanted = useSignal(true);
  const say = useAction(async () => {
    reproductions.put(await setOutcome(motion.id, wanted.peek()));
  });
  const takeBack = useAction(async () => {
    reproductions.put(await takeBackOutcome(motion.id));
  });
  if (motion.backwards) return null;
  const said = motion.outcome?.worked;
  const option = (worked: boolean) => (
    <button
      type="button"
      class={`button outcome tone-${worked ? "good" : "bad"}`}
      aria-pressed={said === worked}
      disabled={say.busy}
      onClick={() => {
        wanted.value = worked;
        say.start();
      }}
    >
      <Icon name={worked ? "check" : "cross"} />
      <span>{worked ? t.feedback.worked : t.feedback.failed}</span>
    </button>
  );
  const problem = say.problem ?? takeBack.problem;
  return (
    <section class="card" aria-label={t.feedback.question}>
      <h2>{t.feedback.question}</h2>
      <div class="side-by-side">
        {option(true)}
        {option(false)}
      </div>
      <p role="status" class="hint">
        {motion.outcome ? t.feedback.thanks : ""}
      </p>
      {problem && <ProblemNotice problem={problem} />}
      {said === false && <Note key={motion.id} motion={motion} />}
      {motion.outcome && (
        <Button
          look="quiet"
          icon="back"
          busy={takeBack.busy && t.feedback.saving}
          onPress={takeBack.start}
        >
          {t.feedback.takeBack}
        </Button>
      )}
    </section>
  );
}

/** What went wrong, in the person's own words. */
function Note({ motion }: { motion: Reproduction }) {
  const stored = motion.outcome?.note ?? "";
  const text = useSignal(stored);
  const save = useAction(async () => {
    reproductions.put(await setOutcome(motion.id, false, text.peek().trim()));
  });
  const changed = text.value.trim() !== stored;
  return (
    <>
      <TextField label={t.feedback.note} text={text} maxLength={400} />
      {changed ? (
        <Button icon="check" busy={save.busy && t.feedback.saving} onPress={save.start}>
          {t.feedback.saveNote}
        </Button>
      ) : (
        stored !== "" && (
          <p role="status" class="hint">
            {t.feedback.noteSaved}
          </p>
        )
      )}
      {save.problem && <ProblemNotice problem={save.problem} />}
    </>
  );
}
