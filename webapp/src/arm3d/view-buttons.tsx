// The picture turned and brought nearer by buttons: nothing may need a finger's movement.
import type { ComponentChildren } from "preact";
import { t } from "../texts";
import type { Stage } from "./stage";
import { from, nearer, turned, type Viewpoint } from "./viewpoint";

const TURN_DEG = 30;
const CLOSER = 1.3;

export function ViewButtons({ stage }: { stage: Stage }) {
  const press = (change: (view: Viewpoint) => Viewpoint) => () => {
    if (stage.wanted) stage.lookSlowly(change(stage.wanted));
  };
  const words = t.arm3d.view;
  return (
    <details class="arm3d-buttons">
      <summary>{words.title}</summary>
      <div class="arm3d-grid">
        <Press onPress={press((view) => turned(view, -TURN_DEG, 0))}>{words.left}</Press>
        <Press onPress={press((view) => turned(view, TURN_DEG, 0))}>{words.right}</Press>
        <Press onPress={press((view) => nearer(view, CLOSER))}>{words.closer}</Press>
        <Press onPress={press((view) => nearer(view, 1 / CLOSER))}>{words.farther}</Press>
      </div>
      <div class="arm3d-grid arm3d-thirds">
        <Press onPress={press((view) => from(view, "front"))}>{words.front}</Press>
        <Press onPress={press((view) => from(view, "side"))}>{words.side}</Press>
        <Press onPress={press((view) => from(view, "top"))}>{words.top}</Press>
      </div>
    </details>
  );
}

function Press({ onPress, children }: { onPress: () => void; children: ComponentChildren }) {
  return (
    <button type="button" class="button button-secondary" onClick={onPress}>
      {children}
    </button>
  );
}
