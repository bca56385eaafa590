// What was just done, with the way back beside it.
import { useAction } from "../state/hooks";
import { t } from "../texts";
import { Button } from "./button";
import { Icon } from "./icon";
import { ProblemNotice } from "./notice";

interface Props {
  words: string;
  undo: () => Promise<void>;
}

export function UndoNotice({ words, undo }: Props) {
  const back = useAction(undo);
  return (
    <div class="undo" role="status">
      <Icon name="info" />
      <p>{words}</p>
      <Button icon="undo" busy={back.busy && t.teaching.undo.undoing} onPress={back.start}>
        {t.teaching.undo.press}
      </Button>
      {back.problem && <ProblemNotice problem={back.problem} />}
    </div>
  );
}
