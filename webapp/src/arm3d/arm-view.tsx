// The arm in three dimensions, as a part of a page. The drawing library is fetched when the first
// picture is shown; without it or without WebGL a sentence stands in its place.
import { useSignal, useSignalEffect, type ReadonlySignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { fixed } from "../format/numbers";
import { scheme } from "../plots/colours";
import { t } from "../texts";
import { watchGestures, type Grip } from "./gestures";
import { toolMm } from "./kinematics";
import type { Pose } from "./poses";
import { toolSpreadMm } from "./spread";
import { Stage } from "./stage";
import { apart } from "./tube";
import type { Vec3 } from "./vector";
import type { Line } from "./scene";
import { ViewButtons } from "./view-buttons";

/** The way of the tool through these poses. */
export interface PathLine {
  look: "path" | "quiet";
  poses: readonly Pose[];
}

/** Poses and how far the joints are spread at each. */
export interface Band {
  poses: readonly Pose[];
  stdDeg: readonly Pose[];
}

interface Props {
  joints: ReadonlySignal<Pose | null>;
  /** Another pose, drawn as a translucent arm. */
  ghost?: ReadonlySignal<Pose | null>;
  paths?: readonly PathLine[];
  band?: Band | null;
  /** Places that have to be in the picture from the beginning. */
  room?: readonly Vec3[];
  /** What is shown, as a sentence for those who do not see it. */
  label: string;
  /** Who takes the ball at the tool; null for a picture that is only looked at. */
  grip?: Grip | null;
  /** As high as the page has room for. */
  fill?: boolean;
  onStage?: (stage: Stage | null) => void;
  /** A few words in the picture. */
  hint?: string | null;
  /** Stands right under the picture. */
  children?: ComponentChildren;
}

const PATH_MM = 4.5;
/** A path is not drawn finer than this: nobody sees it, and it costs triangles. */
const PATH_STEP_MM = 6;
const NOWHERE: readonly Vec3[] = [];
const NO_PATHS: readonly PathLine[] = [];

export function ArmView(props: Props) {
  const { joints, ghost, paths = NO_PATHS, band = null, room = NOWHERE, label, fill } = props;
  const figure = useRef<HTMLElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const stage = useSignal<Stage | null>(null);
  const state = useSignal<"loading" | "shown" | "missing">("loading");
  const latest = useRef(props);
  latest.current = props;

  useEffect(() => {
    let gone = false;
    let stop = () => {};
    void begin(canvas.current!, (pose) =>
      describe(figure.current, latest.current.label, pose),
    ).then((made) => {
      if (gone) return made?.dispose();
      state.value = made ? "shown" : "missing";
      if (!made) return;
      const unwatch = watchGestures(canvas.current!, made, () => latest.current.grip ?? null);
      stop = () => {
        unwatch();
        made.dispose();
      };
      stage.value = made;
      latest.current.onStage?.(made);
    });
    return () => {
      gone = true;
      latest.current.onStage?.(null);
      stop();
    };
  }, []);

  useSignalEffect(() => stage.value?.setPose(joints.value));
  useEffect(() => stage.value?.setRoom(room), [stage.value, room]);
  useEffect(() => stage.value?.setPalette(), [stage.value, scheme.value]);
  useEffect(() => {
    stage.value?.setLines([...paths.map(lineOf), ...(band ? [bandOf(band)] : [])]);
  }, [stage.value, paths, band]);
  const holding = props.grip != null;
  useEffect(() => stage.value?.setHandle(holding, null), [stage.value, holding]);

  return (
    <figure ref={figure} class={fill ? "arm3d arm3d-fill" : "arm3d"} data-state={state.value}>
      {ghost && stage.value && <Ghost stage={stage.value} pose={ghost} />}
      <div class="arm3d-picture" role="img" aria-label={label}>
        <canvas ref={canvas} aria-hidden="true" hidden={state.value === "missing"} />
        {state.value === "loading" && <p class="arm3d-words">{t.arm3d.loading}</p>}
        {state.value === "missing" && <p class="arm3d-words">{t.arm3d.missing}</p>}
        {state.value === "shown" && props.hint && <p class="arm3d-hint">{props.hint}</p>}
      </div>
      {props.children}
      {stage.value && <ViewButtons stage={stage.value} />}
    </figure>
  );
}

function Ghost({ stage, pose }: { stage: Stage; pose: ReadonlySignal<Pose | null> }) {
  useSignalEffect(() => stage.setGhost(pose.value));
  return null;
}

async function begin(canvas: HTMLCanvasElement, drawn: (stage: Stage) => void) {
  try {
    const { ArmScene } = await import("./scene");
    // The page first, then the picture: a press is answered before the graphics are prepared.
    await new Promise((painted) => requestAnimationFrame(() => setTimeout(painted)));
    const scene = new ArmScene(canvas);
    const stage = new Stage(canvas, scene, drawn);
    await scene.prepare();
    return stage;
  } catch {
    // No WebGL, or the file could not be fetched: the plots and numbers say the same.
    return null;
  }
}

/** Says where the tool is, and for tests which pose is in the picture and where its tool is. */
function describe(figure: HTMLElement | null, label: string, drawn: Stage): void {
  const [pose, at] = [drawn.shownPose, drawn.toolAt];
  if (!figure || !pose || !at) return;
  figure.dataset["pose"] = pose.map((angle) => angle.toFixed(2)).join(" ");
  figure.dataset["toolAt"] = `${at.x.toFixed(0)} ${at.y.toFixed(0)}`;
  const [x, y, z] = toolMm(pose).map((value) => fixed(value / 10, 0)) as [string, string, string];
  figure.firstElementChild?.setAttribute("aria-label", `${label} ${t.arm3d.tool(x, y, z)}`);
}

function lineOf({ look, poses }: PathLine): Line {
  const placesMm = apart(poses.map(toolMm), (place) => place, PATH_STEP_MM);
  return { look, placesMm, radiusMm: () => (look === "path" ? PATH_MM : PATH_MM * 0.7) };
}

function bandOf({ poses, stdDeg }: Band): Line {
  const all = poses.map((pose, point) => ({
    placeMm: toolMm(pose),
    spreadMm: toolSpreadMm(pose, stdDeg[point] ?? []),
  }));
  const rings = apart(all, (ring) => ring.placeMm, PATH_STEP_MM * 2);
  // Never thinner than the path inside it.
  const radiusMm = (point: number) => Math.max(PATH_MM * 1.5, rings[point]!.spreadMm);
  return { look: "band", placesMm: rings.map((ring) => ring.placeMm), radiusMm };
}
