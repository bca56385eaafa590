// The saved positions of this robot: one tap saves where the arm is now, and each can be given
// another name or place.
import { useComputed, useSignal } from "@preact/signals";
import { changePosition, deletePosition, savePresentPosition } from "../../api/endpoints";
import { newId } from "../../api/ids";
import type { Position } from "../../api/types";
import { Button } from "../../components/button";
import { LoadNotice, Notice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { degrees } from "../../format/numbers";
import { useAction, useLoad } from "../../state/hooks";
import { robot } from "../../state/live";
import { freeName, loadPositions, ourPositions, positions } from "../../state/positions";
import { robotId } from "../../state/robots";
import { t } from "../../texts";
import { TextField } from "../../components/text-field";
import { Asked } from "../../components/asked";

export function PositionsPage({ task }: { task: string }) {
  const load = useLoad(loadPositions, robotId.value);
  const known = useComputed(() => robot.value?.joints_deg != null);
  const saved = useSignal<Position | null>(null);
  const list = ourPositions();
  const save = useAction(async () => {
    const position = await savePresentPosition(
      newId(),
      robotId.peek(),
      freeName(ourPositions().map((one) => one.name)),
    );
    positions.put(position);
    saved.value = position;
  });
  // With its own name nothing is left to say about it.
  const fresh = list.find((one) => one.id === saved.value?.id && one.name === saved.value.name);
  return (
    <Page
      title={t.positions.title}
      back={{ page: "setup", task }}
      actions={
        <Button
          look="primary"
          icon="plus"
          why={known.value ? null : t.run.presentMissing}
          busy={save.busy && t.positions.saving}
          onPress={save.start}
        >
          {t.positions.save}
        </Button>
      }
    >
      {save.problem && <ProblemNotice problem={save.problem} />}
      <LoadNotice load={load} empty={list.length === 0} />
      {fresh && (
        <div role="status">
          <Notice tone="good" icon="check">
            <p>{t.positions.saved(fresh.name)}</p>
          </Notice>
        </div>
      )}
      {list.length === 0 && !load.loading && !load.problem && <p>{t.positions.none}</p>}
      <ul class="rows">
        {list.map((one) => (
          <li key={one.id}>
            <Entry position={one} opened={one.id === saved.value?.id} known={known.value} />
          </li>
        ))}
      </ul>
    </Page>
  );
}

interface EntryProps {
  position: Position;
  /** It was just saved, so its name is the next thing to be typed. */
  opened: boolean;
  /** Where the arm stands. */
  known: boolean;
}

function Entry({ position, opened, known }: EntryProps) {
  const open = useSignal(opened);
  const angles = position.joints_deg.map((value) => degrees(value)).join(", ");
  return (
    <section class="card" aria-label={position.name}>
      <div class="row-name">
        <strong>{position.name}</strong>
        <span>{t.positions.angles(angles)}</span>
      </div>
      {open.value ? (
        <>
          <Rename position={position} />
          <Asked
            icon="move"
            press={t.positions.move}
            question={t.positions.moveAsk(position.name)}
            yes={t.positions.moveYes}
            no={t.positions.no}
            busy={t.positions.saving}
            why={known ? null : t.run.presentMissing}
            act={async () => {
              positions.put(await changePosition(position.id, { present: true }));
            }}
          />
          <Asked
            icon="bin"
            press={t.positions.remove}
            question={t.positions.removeAsk(position.name)}
            yes={t.positions.removeYes}
            no={t.positions.no}
            busy={t.positions.saving}
            act={async () => {
              await deletePosition(position.id);
              positions.forget(position.id);
            }}
          />
          <Button icon="cross" onPress={() => (open.value = false)}>
            {t.positions.close}
          </Button>
        </>
      ) : (
        <Button icon="pencil" onPress={() => (open.value = true)}>
          {t.positions.edit(position.name)}
        </Button>
      )}
    </section>
  );
}

function Rename({ position }: { position: Position }) {
  const text = useSignal(position.name);
  const rename = useAction(async () => {
    positions.put(await changePosition(position.id, { name: text.value.trim() }));
  });
  return (
    <>
      <TextField label={t.positions.name} text={text} maxLength={80} />
      <Button
        icon="check"
        why={text.value.trim() === "" ? t.positions.nameMissing : null}
        busy={rename.busy && t.positions.saving}
        onPress={rename.start}
      >
        {t.positions.rename}
      </Button>
      {rename.problem && <ProblemNotice problem={rename.problem} />}
    </>
  );
}
