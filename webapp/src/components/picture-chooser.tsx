// Choosing a task's photo: from the camera, or one that the phone has.
import { useRef } from "preact/hooks";
import { useAction } from "../state/hooks";
import { shrunk } from "../state/picture";
import { t } from "../texts";
import { Button } from "./button";
import { ProblemNotice } from "./notice";

interface Props {
  /** Gets the photo, small enough to be sent. */
  onPicked: (photo: Blob) => Promise<void>;
}

export function PictureChooser({ onPicked }: Props) {
  const camera = useRef<HTMLInputElement>(null);
  const gallery = useRef<HTMLInputElement>(null);
  const picked = useRef<File | null>(null);
  const use = useAction(async () => {
    if (picked.current) await onPicked(await shrunk(picked.current));
  });
  const input = (place: typeof camera, label: string, more: { capture?: "environment" } = {}) => (
    <input
      {...more}
      ref={place}
      class="hidden-input"
      type="file"
      accept="image/*"
      tabIndex={-1}
      aria-label={label}
      onChange={(event) => {
        picked.current = event.currentTarget.files?.[0] ?? null;
        // The same photo may be chosen again after something went wrong.
        event.currentTarget.value = "";
        use.start();
      }}
    />
  );
  return (
    <div class="picture-chooser">
      {input(camera, t.teaching.picture.take, { capture: "environment" })}
      {input(gallery, t.teaching.picture.choose)}
      <div class="side-by-side">
        <Button
          icon="camera"
          busy={use.busy && t.teaching.picture.preparing}
          onPress={() => camera.current?.click()}
        >
          {t.teaching.picture.take}
        </Button>
        <Button icon="upload" onPress={() => gallery.current?.click()}>
          {t.teaching.picture.choose}
        </Button>
      </div>
      {use.problem && <ProblemNotice problem={use.problem} />}
    </div>
  );
}
