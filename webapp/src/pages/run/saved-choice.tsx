// Which saved position a motion begins or ends at.
import { ButtonLink } from "../../components/button";
import { Choice } from "../../components/choice";
import { LoadNotice } from "../../components/notice";
import { degrees } from "../../format/numbers";
import { useLoad } from "../../state/hooks";
import { loadPositions, ourPositions } from "../../state/positions";
import { robotId } from "../../state/robots";
import { t } from "../../texts";

interface Props {
  task: string;
  legend: string;
  value: string | undefined;
  onChoose: (position: string) => void;
}

export function SavedChoice({ task, legend, value, onChoose }: Props) {
  const load = useLoad(loadPositions, robotId.value);
  const list = ourPositions();
  return (
    <>
      <LoadNotice load={load} empty={list.length === 0} />
      {list.length > 0 && (
        <Choice
          legend={legend}
          options={list.map((one) => ({
            value: one.id,
            name: one.name,
            detail: one.joints_deg.map((angle) => degrees(angle)).join(", "),
          }))}
          value={value ?? ""}
          onChoose={onChoose}
        />
      )}
      {list.length === 0 && !load.loading && <p>{t.positions.noneHere}</p>}
      <ButtonLink to={{ page: "positions", task }} icon="pencil">
        {t.positions.manage}
      </ButtonLink>
    </>
  );
}
