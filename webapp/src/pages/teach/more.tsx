// The rarer things of a task: a file as a take, moving the arm by hand, renaming, deleting.
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { renameTask, uploadDemonstration } from "../../api/endpoints";
import { Button } from "../../components/button";
import { LoadNotice, Notice, ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { SoftArm } from "../../components/soft-arm";
import type { Task } from "../../api/types";
import { deleteTask } from "../../state/decisions";
import { demonstrations, loadTask, tasks } from "../../state/entities";
import { useAction, useLoad } from "../../state/hooks";
import { go } from "../../state/navigation";
import { t } from "../../texts";
import { TaskPhoto } from "./task-photo";
import { TextField } from "../../components/text-field";
import { Asked } from "../../components/asked";

export function MorePage({ task }: { task: string }) {
  const load = useLoad(() => loadTask(task), task);
  const known = tasks.get(task);
  return (
    <Page title={t.teach.moreTitle} back={{ page: "task", task }}>
      <LoadNotice load={load} empty={known === undefined} />
      <SoftArm />
      <Upload task={task} />
      {known && <TaskPhoto task={known} />}
      {known && <Rename task={task} name={known.name} />}
      {known && <Remove task={known} />}
    </Page>
  );
}

function Upload({ task }: { task: string }) {
  const input = useRef<HTMLInputElement>(null);
  const added = useSignal<number | null>(null);
  const upload = useAction(async () => {
    const file = input.current?.files?.[0];
    if (!file) return;
    added.value = null;
    const take = await uploadDemonstration(task, file);
    demonstrations.put(take);
    added.value = take.take;
    // The same file may be chosen again, after it was corrected.
    if (input.current) input.current.value = "";
  });
  return (
    <section class="card">
      <h2>{t.teach.upload}</h2>
      <p>{t.teach.uploadHint}</p>
      <input
        ref={input}
        class="hidden-input"
        type="file"
        accept=".csv,.json,text/csv,application/json"
        tabIndex={-1}
        aria-label={t.teach.upload}
        onChange={upload.start}
      />
      <Button
        icon="upload"
        busy={upload.busy && t.teach.uploading}
        onPress={() => input.current?.click()}
      >
        {t.teach.uploadChoose}
      </Button>
      {added.value !== null && (
        <Notice tone="good" icon="check">
          {t.teach.uploaded(added.value)}
        </Notice>
      )}
      {upload.problem && <ProblemNotice problem={upload.problem} />}
    </section>
  );
}

function Rename({ task, name }: { task: string; name: string }) {
  const text = useSignal(name);
  const rename = useAction(async () => tasks.put(await renameTask(task, text.value.trim())));
  return (
    <section class="card">
      <TextField label={t.teach.name} text={text} maxLength={80} />
      <Button
        icon="pencil"
        why={text.value.trim() === "" ? t.teach.nameMissing : null}
        busy={rename.busy && t.teach.renaming}
        onPress={rename.start}
      >
        {t.teach.rename}
      </Button>
      {rename.problem && <ProblemNotice problem={rename.problem} />}
    </section>
  );
}

function Remove({ task }: { task: Task }) {
  return (
    <section class="card">
      <Asked
        icon="bin"
        press={t.teach.remove}
        question={t.teach.removeAsk}
        yes={t.teach.removeYes}
        no={t.teach.removeNo}
        busy={t.teach.removing}
        act={async () => {
          await deleteTask(task);
          go({ page: "teach" }, true);
        }}
      />
    </section>
  );
}
