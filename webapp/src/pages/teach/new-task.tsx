// Naming a new task.
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { createTask, putPicture } from "../../api/endpoints";
import { newId } from "../../api/ids";
import { Button } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { PictureChooser } from "../../components/picture-chooser";
import { tasks } from "../../state/entities";
import { useAction } from "../../state/hooks";
import { go } from "../../state/navigation";
import { asAddress } from "../../state/picture";
import { t } from "../../texts";
import { TextField } from "../../components/text-field";

export function NewTaskPage() {
  const name = useSignal("");
  // One id for all trials: a repeated request makes one task.
  const id = useMemo(() => newId(), []);
  const photo = useSignal<{ file: Blob; address: string } | null>(null);
  const create = useAction(async () => {
    let task = await createTask(id, name.value.trim());
    if (photo.value) task = await putPicture(task.id, photo.value.file);
    tasks.put(task);
    go({ page: "record", task: task.id }, true);
  });
  const missing = name.value.trim() === "";
  return (
    <Page
      title={t.teach.newTask}
      back={{ page: "teach" }}
      actions={
        <Button
          look="primary"
          icon="check"
          why={missing ? t.teach.nameMissing : null}
          busy={create.busy && t.teach.creating}
          onPress={create.start}
        >
          {t.teach.create}
        </Button>
      }
    >
      <form
        onSubmit={(event) => {
          event.preventDefault();
          if (!missing) create.start();
        }}
      >
        <TextField label={t.teach.name} text={name} maxLength={80} done />
        <p class="hint">{t.teach.nameExample}</p>
      </form>
      {photo.value && <img class="picture-shown" src={photo.value.address} alt="" />}
      <PictureChooser
        onPicked={async (file) => {
          photo.value = { file, address: await asAddress(file) };
        }}
      />
      {create.problem && <ProblemNotice problem={create.problem} />}
    </Page>
  );
}
