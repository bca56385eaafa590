// A task's photo: to be taken, exchanged and taken away.
import { deletePicture, pictureAddress, putPicture } from "../../api/endpoints";
import type { Task } from "../../api/types";
import { Button } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import { PictureChooser } from "../../components/picture-chooser";
import { tasks } from "../../state/entities";
import { useAction } from "../../state/hooks";
import { t } from "../../texts";

export function TaskPhoto({ task }: { task: Task }) {
  const remove = useAction(async () => tasks.put(await deletePicture(task.id)));
  return (
    <section class="card">
      <h2>{t.teaching.picture.title}</h2>
      {task.picture ? (
        <img class="picture-shown" src={pictureAddress(task.id, task.picture)} alt="" />
      ) : (
        <p>{t.teaching.picture.explain}</p>
      )}
      <PictureChooser onPicked={async (file) => tasks.put(await putPicture(task.id, file))} />
      {task.picture && (
        <Button icon="bin" busy={remove.busy && t.teaching.picture.removing} onPress={remove.start}>
          {t.teaching.picture.remove}
        </Button>
      )}
      {remove.problem && <ProblemNotice problem={remove.problem} />}
    </section>
  );
}
