// From a trained motion straight to its preview, and the way to other choices when that is refused.
import type { Problem } from "../../api/problem";
import { Button, ButtonLink, type Look } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import type { Action } from "../../state/hooks";
import { t } from "../../texts";

export function RunButton({ run, look }: { run: Action; look: Look }) {
  return (
    <Button look={look} icon="play" busy={run.busy && t.teaching.planning} onPress={run.start}>
      {t.teach.runIt}
    </Button>
  );
}

/** The motion as it was taught can't be planned: another start, goal or speed may do. */
export function RefusedRun({ task, problem }: { task: string; problem: Problem }) {
  return (
    <>
      <ProblemNotice title={t.run.refused} problem={problem} />
      <ButtonLink to={{ page: "setup", task }} icon="pencil">
        {t.teaching.change}
      </ButtonLink>
    </>
  );
}
