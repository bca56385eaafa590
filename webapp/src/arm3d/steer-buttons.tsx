// Leading the virtual arm by buttons, for a keyboard and for hands that cannot aim: the tool moves
// as long as one is pressed.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { armDrag } from "../state/live";
import { t } from "../texts";
import { toolFrame } from "./kinematics";
import type { Stage } from "./stage";
import { steered, type Steer, type Steered } from "./steering";
import { directionOf, type Way } from "./viewpoint";
import { scale } from "./vector";

const WAYS: readonly Way[] = ["left", "right", "up", "down", "back", "forward"];
/** A press by a screen reader has no length: it moves the tool a little. */
const NUDGE_MS = 250;

const TURNS = ["twistLeft", "twistRight", "tiltLeft", "tiltRight", "tiltBack", "tiltAway"] as const;
type Turn = (typeof TURNS)[number];

export function SteerButtons({ stage }: { stage: Stage }) {
  const pressed = useSignal<Way | Turn | null>(null);
  const stop = useRef<(() => void) | null>(null);
  const release = () => {
    stop.current?.();
    stop.current = null;
    pressed.value = null;
  };
  const hold = (what: Way | Turn) => {
    const steer = steerOf(stage, what);
    if (stop.current || armDrag.held || !steer) return;
    pressed.value = what;
    stop.current = lead(stage, steer);
  };
  useEffect(() => {
    const hidden = () => document.visibilityState === "hidden" && release();
    window.addEventListener("blur", release);
    document.addEventListener("visibilitychange", hidden);
    return () => {
      window.removeEventListener("blur", release);
      document.removeEventListener("visibilitychange", hidden);
      release();
    };
  }, []);
  const buttons = (list: readonly (Way | Turn)[]) =>
    list.map((what) => (
      <button
        key={what}
        type="button"
        class="button button-secondary"
        aria-pressed={pressed.value === what}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          hold(what);
        }}
        onPointerUp={release}
        onPointerCancel={release}
        onLostPointerCapture={release}
        onContextMenu={(event) => event.preventDefault()}
        onKeyDown={(event) => {
          if (event.key !== " " && event.key !== "Enter") return;
          event.preventDefault();
          if (!event.repeat) hold(what);
        }}
        onKeyUp={(event) => {
          event.preventDefault();
          release();
        }}
        onBlur={release}
        onClick={(event) => {
          if (event.detail > 0) return;
          hold(what);
          setTimeout(release, NUDGE_MS);
        }}
      >
        {t.arm3d.drag[what]}
      </button>
    ));
  return (
    <details class="arm3d-buttons">
      <summary>{t.arm3d.drag.buttons}</summary>
      <p>{t.arm3d.drag.hold}</p>
      <div class="arm3d-grid arm3d-hold">{buttons(WAYS)}</div>
      <div class="arm3d-grid arm3d-hold">{buttons(TURNS)}</div>
    </details>
  );
}

/** Directions are meant as seen in the picture at the moment of the press. */
function steerOf(stage: Stage, what: Way | Turn): Steer | null {
  const [view, pose] = [stage.viewpoint, stage.shownPose];
  if (!view || !pose) return null;
  const along = (way: Way) => directionOf(view, way);
  switch (what) {
    case "twistLeft":
      return { kind: "turn", axis: toolFrame(pose).z };
    case "twistRight":
      return { kind: "turn", axis: scale(toolFrame(pose).z, -1) };
    case "tiltLeft":
      return { kind: "turn", axis: along("back") };
    case "tiltRight":
      return { kind: "turn", axis: along("forward") };
    case "tiltBack":
      return { kind: "turn", axis: along("right") };
    case "tiltAway":
      return { kind: "turn", axis: along("left") };
    default:
      return { kind: "move", direction: along(what) };
  }
}

/** Moves the target until the function that it returns is called. */
function lead(stage: Stage, steer: Steer): () => void {
  const pose = stage.shownPose;
  if (!pose) return () => {};
  const taken = toolFrame(pose);
  let target: Steered = { toolMm: taken.originMm, turnDeg: [0, 0, 0] };
  let last = performance.now();
  let frame = 0;
  armDrag.begin();
  const step = () => {
    const now = performance.now();
    const toolMm = stage.toolMm ?? target.toolMm;
    target = steered(target, steer, Math.min(0.1, (now - last) / 1000), taken, toolMm);
    last = now;
    armDrag.move({ tool_mm: target.toolMm, turn_deg: target.turnDeg });
    if (armDrag.held) frame = requestAnimationFrame(step);
  };
  step();
  return () => {
    cancelAnimationFrame(frame);
    armDrag.end();
  };
}
