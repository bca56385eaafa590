// The invitation to the questionnaire after a motion: shown when the server says that this person
// was not asked in this shift, and gone with one tap.
import { useSignal } from "@preact/signals";
import { questionnaireDue, sendReply } from "../../api/endpoints";
import { newId } from "../../api/ids";
import type { Reproduction } from "../../api/types";
import { Button, ButtonLink } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import { useAction, useLoad } from "../../state/hooks";
import { person, settle, settled } from "../../state/person";
import { t } from "../../texts";

export function QuestionnaireInvite({ motion }: { motion: Reproduction }) {
  const due = useSignal(false);
  // Nobody misses an invitation that could not be looked up, so a failure says nothing.
  useLoad(async () => {
    due.value = !motion.backwards && (await questionnaireDue(person(), motion.id)).due;
  }, motion.id);
  const skip = useAction(async () => {
    await sendReply({
      id: newId(),
      person: person(),
      task_id: motion.task_id,
      reproduction_id: motion.id,
    });
    settle(motion.id);
  });
  if (!due.value || settled.value.has(motion.id)) return null;
  return (
    <section class="card" aria-label={t.feedback.invite}>
      <h2>{t.feedback.invite}</h2>
      <p>{t.feedback.inviteDetail}</p>
      <div class="side-by-side">
        <ButtonLink
          to={{ page: "questions", task: motion.task_id, motion: motion.id }}
          icon="pencil"
        >
          {t.feedback.answer}
        </ButtonLink>
        <Button icon="cross" busy={skip.busy && t.feedback.skipping} onPress={skip.start}>
          {t.feedback.skip}
        </Button>
      </div>
      {skip.problem && <ProblemNotice problem={skip.problem} />}
    </section>
  );
}
