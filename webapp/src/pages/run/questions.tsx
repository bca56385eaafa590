// The questionnaire: five statements, each with a row of five big answers.
import { useSignal } from "@preact/signals";
import { useId, useMemo } from "preact/hooks";
import { sendReply } from "../../api/endpoints";
import { newId } from "../../api/ids";
import { Button } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { useAction } from "../../state/hooks";
import { go } from "../../state/navigation";
import { person, settle } from "../../state/person";
import { t } from "../../texts";

/** In the order in which the server keeps the answers. */
export const STATEMENTS = ["learned", "safe", "accurate", "simple", "enjoyable"] as const;

const SCALE = [1, 2, 3, 4, 5] as const;

export function QuestionsPage({ task, motion }: { task: string; motion: string }) {
  const answers = useSignal<readonly (number | null)[]>(STATEMENTS.map(() => null));
  // One id for all trials: a repeated request is one reply.
  const id = useMemo(() => newId(), []);
  const reply = async (given?: number[]) => {
    const about = { person: person(), task_id: task, reproduction_id: motion };
    await sendReply(given ? { id, ...about, answers: given } : { id, ...about });
    settle(motion);
    go({ page: "motion", task, motion }, true);
  };
  const send = useAction(() => reply(answers.peek().map((answer) => answer ?? 0)));
  const skip = useAction(() => reply());
  const open = answers.value.filter((answer) => answer === null).length;
  const problem = send.problem ?? skip.problem;
  return (
    <Page
      title={t.feedback.title}
      back={{ page: "motion", task, motion }}
      actions={
        <>
          <Button icon="cross" busy={skip.busy && t.feedback.skipping} onPress={skip.start}>
            {t.feedback.skip}
          </Button>
          <Button
            look="primary"
            icon="check"
            why={open > 0 ? t.feedback.missing(String(open)) : null}
            busy={send.busy && t.feedback.sending}
            onPress={send.start}
          >
            {t.feedback.send}
          </Button>
        </>
      }
    >
      {problem && <ProblemNotice problem={problem} />}
      <p>{t.feedback.explain}</p>
      {STATEMENTS.map((statement, index) => (
        <Statement
          key={statement}
          words={t.feedback.statements[statement]}
          value={answers.value[index] ?? null}
          onAnswer={(answer) => (answers.value = answers.peek().with(index, answer))}
        />
      ))}
    </Page>
  );
}

interface StatementProps {
  words: string;
  value: number | null;
  onAnswer: (answer: number) => void;
}

/** Radio buttons underneath, so keyboard and screen reader work; each says what its number means. */
function Statement({ words, value, onAnswer }: StatementProps) {
  const group = useId();
  return (
    <fieldset class="rating" role="radiogroup">
      <legend>{words}</legend>
      <div class="rating-scale">
        {SCALE.map((answer) => (
          <label key={answer} class="choice-card rating-answer">
            <input
              type="radio"
              name={group}
              value={answer}
              checked={answer === value}
              aria-label={t.feedback.scale[answer] ?? String(answer)}
              onChange={() => onAnswer(answer)}
            />
            <span aria-hidden="true">{answer}</span>
          </label>
        ))}
      </div>
      <div class="rating-ends" aria-hidden="true">
        <span>{t.feedback.lowest}</span>
        <span>{t.feedback.highest}</span>
      </div>
    </fieldset>
  );
}
