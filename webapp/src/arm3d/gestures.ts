// What a finger or a mouse does on the picture: it takes the ball at the tool along, or turns the
// picture. Sideways turns; up and down scrolls the page as everywhere, so a picture never holds
// the page back. A mouse turns in all directions.
import type { Stage } from "./stage";
import { nearer, onScreen, turned, underFinger } from "./viewpoint";
import { subtract, add, type Vec3 } from "./vector";

/** A little more than the ball that is drawn: fingers hide what they aim at. */
const GRAB_PX = 44;
const DEGREES_PER_PIXEL = 0.45;
const WHEEL = 0.005;

export interface Grip {
  begin(): void;
  move(toMm: Vec3): void;
  end(): void;
}

interface Held {
  pointer: number;
  /** From the finger to the middle of the ball, so that it does not jump when it is taken. */
  offMm: Vec3;
  atMm: Vec3;
}

/** Starts listening; returns what ends it. `grip` says who takes the ball, or null for no ball. */
export function watchGestures(
  canvas: HTMLCanvasElement,
  stage: Stage,
  grip: () => Grip | null,
): () => void {
  let turning: { pointer: number; x: number; y: number; mouse: boolean } | null = null;
  let held: Held | null = null;
  let taker: Grip | null = null;

  const at = (event: { clientX: number; clientY: number }) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top] as const;
  };
  const onBall = (event: { clientX: number; clientY: number }): boolean => {
    const [tool, view] = [stage.toolMm, stage.viewpoint];
    if (!tool || !view || grip() === null) return false;
    const ball = onScreen(view, stage.pixels, tool);
    const [x, y] = at(event);
    return Math.hypot(ball.x - x, ball.y - y) <= GRAB_PX;
  };
  const release = () => {
    if (!held) return;
    held = null;
    stage.setHandle(grip() !== null, null);
    taker?.end();
    taker = null;
  };

  const down = (event: PointerEvent) => {
    if (!event.isPrimary || event.button !== 0) return;
    const [tool, view] = [stage.toolMm, stage.viewpoint];
    if (!tool || !view) return;
    const [x, y] = at(event);
    canvas.setPointerCapture(event.pointerId);
    if (onBall(event)) {
      const under = underFinger(view, stage.pixels, x, y, tool);
      held = { pointer: event.pointerId, offMm: subtract(tool, under), atMm: tool };
      taker = grip();
      taker?.begin();
      stage.setHandle(true, tool);
    } else {
      turning = { pointer: event.pointerId, x, y, mouse: event.pointerType === "mouse" };
    }
  };
  const move = (event: PointerEvent) => {
    const [x, y] = at(event);
    const view = stage.viewpoint;
    if (!view) return;
    if (held?.pointer === event.pointerId) {
      held.atMm = add(underFinger(view, stage.pixels, x, y, held.atMm), held.offMm);
      stage.setHandle(true, held.atMm);
      taker?.move(held.atMm);
    } else if (turning?.pointer === event.pointerId) {
      const rise = turning.mouse ? (y - turning.y) * DEGREES_PER_PIXEL : 0;
      stage.look(turned(view, (turning.x - x) * DEGREES_PER_PIXEL, rise));
      turning = { ...turning, x, y };
    }
  };
  const up = (event: PointerEvent) => {
    if (held?.pointer === event.pointerId) release();
    if (turning?.pointer === event.pointerId) turning = null;
  };
  /** Only a finger on the ball keeps the page from scrolling. */
  const touch = (event: TouchEvent) => {
    const finger = event.touches[0];
    if (finger && event.touches.length === 1 && onBall(finger)) event.preventDefault();
  };
  const wheel = (event: WheelEvent) => {
    // Without a key the wheel scrolls the page; browsers report a pinch as a wheel with this key.
    if (!event.ctrlKey || !stage.viewpoint) return;
    event.preventDefault();
    stage.look(nearer(stage.viewpoint, Math.exp(-event.deltaY * WHEEL)));
  };
  const hidden = () => {
    if (document.visibilityState === "hidden") release();
  };
  const noMenu = (event: Event) => event.preventDefault();

  const ends = new AbortController();
  const { signal } = ends;
  canvas.addEventListener("pointerdown", down, { signal });
  canvas.addEventListener("pointermove", move, { signal });
  for (const name of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
    canvas.addEventListener(name, up, { signal });
  }
  canvas.addEventListener("touchstart", touch, { signal, passive: false });
  canvas.addEventListener("wheel", wheel, { signal, passive: false });
  canvas.addEventListener("contextmenu", noMenu, { signal });
  window.addEventListener("blur", release, { signal });
  window.addEventListener("pagehide", release, { signal });
  document.addEventListener("visibilitychange", hidden, { signal });
  return () => {
    release();
    ends.abort();
  };
}
