// One picture on the page: its canvas, where it is seen from, and when it has to be drawn anew.
// Nothing is drawn while nothing changes or while the picture is scrolled away.
import { colour } from "../plots/colours";
import { centreLineMm, toolMm } from "./kinematics";
import type { Pose } from "./poses";
import type { ArmScene, Line, Palette } from "./scene";
import { blend, onScreen, overview, type Size, type Viewpoint } from "./viewpoint";
import type { Vec3 } from "./vector";

/** The ball at the tool: as wide as a gloved fingertip, however far away the tool is. */
const HANDLE_PX = 34;
const TURN_S = 0.35;
/** A movement of fewer pictures than these in a second is not one: then each gets less fine. */
const SLOWEST_MS = 45;
const SLOW_PICTURES = 8;

export class Stage {
  private view: Viewpoint | null = null;
  private turn: { from: Viewpoint; to: Viewpoint; sinceMs: number } | null = null;
  private size: Size = { width: 1, height: 1 };
  private pose: Pose | null = null;
  private frame = 0;
  private seen = true;
  /** Where the handle is held; null while it rests at the tool. */
  private heldMm: Vec3 | null = null;
  private withHandle = false;
  private room: readonly Vec3[] = [];
  private lastMs = 0;
  private slow = 0;
  private readonly watches: { disconnect(): void }[] = [];

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly scene: ArmScene,
    private readonly drawn: (stage: Stage) => void,
  ) {
    this.setPalette();
    const resized = new ResizeObserver(() => this.measure());
    resized.observe(canvas);
    const scrolled = new IntersectionObserver((entries) => {
      this.seen = entries.at(-1)?.isIntersecting ?? true;
      this.changed();
    });
    scrolled.observe(canvas);
    this.watches.push(resized, scrolled);
    canvas.addEventListener("webglcontextrestored", this.restored);
    this.measure();
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.watches.forEach((watch) => watch.disconnect());
    this.canvas.removeEventListener("webglcontextrestored", this.restored);
    // Not while the next page is waited for.
    setTimeout(() => this.scene.dispose());
  }

  setPalette(): void {
    const names = ["body", "joint", "metal", "mark", "ground", "grid", "shadow", "ghost"] as const;
    const own = Object.fromEntries(names.map((name) => [name, colour(`arm-${name}`)]));
    const shared = {
      path: colour("plot-first"),
      band: colour("plot-first"),
      quiet: colour("edge"),
      handle: colour("plot-second"),
    };
    this.scene.setPalette({ ...own, ...shared } as Palette);
    this.changed();
  }

  setPose(pose: Pose | null): void {
    this.pose = pose;
    if (pose) this.scene.setPose(pose);
    this.changed();
  }

  setGhost(pose: Pose | null): void {
    this.scene.setGhost(pose);
    this.changed();
  }

  setLines(lines: readonly Line[]): void {
    this.scene.setLines(lines);
    this.changed();
  }

  /** What has to be in the picture besides the arm when it first appears. */
  setRoom(places: readonly Vec3[]): void {
    this.room = places;
    this.view = null;
    this.changed();
  }

  setHandle(shown: boolean, heldMm: Vec3 | null): void {
    this.withHandle = shown;
    this.heldMm = heldMm;
    this.changed();
  }

  get shownPose(): Pose | null {
    return this.pose;
  }

  get toolMm(): Vec3 | null {
    return this.pose && toolMm(this.pose);
  }

  /** Where the tool is in the picture, in its pixels. */
  get toolAt(): { x: number; y: number } | null {
    const tool = this.toolMm;
    return tool && this.view && onScreen(this.view, this.size, tool);
  }

  /** Where it is seen from at this moment. */
  get viewpoint(): Viewpoint | null {
    return this.view;
  }

  get pixels(): Size {
    return this.size;
  }

  /** At once, as under a finger. */
  look(view: Viewpoint): void {
    this.turn = null;
    this.view = view;
    this.changed();
  }

  /** With a short movement that the eye can follow, unless the phone asks for none. */
  lookSlowly(to: Viewpoint): void {
    if (!this.view || matchMedia("(prefers-reduced-motion: reduce)").matches) return this.look(to);
    this.turn = { from: this.view, to, sinceMs: performance.now() };
    this.changed();
  }

  /** Where a turn under way ends: the next press goes on from there. */
  get wanted(): Viewpoint | null {
    return this.turn?.to ?? this.view;
  }

  private readonly restored = () => this.changed();

  private measure(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width < 1 || height < 1) return;
    this.size = { width, height };
    this.scene.setSize(this.size, this.slow < SLOW_PICTURES ? devicePixelRatio : 1);
    // Setting the size clears the picture: it is drawn again before it is seen empty.
    this.paint();
  }

  private changed(): void {
    if (this.frame !== 0 || !this.seen) return;
    this.frame = requestAnimationFrame((nowMs) => {
      this.watchPace(nowMs);
      this.paint();
    });
  }

  /** Counts pictures that came late in a movement; many of them are a phone that cannot do it. */
  private watchPace(nowMs: number): void {
    const tookMs = nowMs - this.lastMs;
    this.lastMs = nowMs;
    // Longer ago, nothing was to be drawn in between.
    if (this.slow >= SLOW_PICTURES || tookMs > 250) return;
    this.slow = tookMs > SLOWEST_MS ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow === SLOW_PICTURES) this.measure();
  }

  private paint(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.goOnTurning();
    this.view ??= this.firstView();
    if (this.view) {
      this.placeHandle(this.view);
      this.scene.draw(this.view);
    }
    this.drawn(this);
    if (this.turn) this.changed();
  }

  private goOnTurning(): void {
    if (!this.turn) return;
    const { from, to, sinceMs } = this.turn;
    const share = Math.min(1, Math.max(0, (performance.now() - sinceMs) / (TURN_S * 1000)));
    this.view = blend(from, to, share * share * (3 - 2 * share));
    if (share === 1) this.turn = null;
  }

  private firstView(): Viewpoint | null {
    const arm = this.pose ? centreLineMm(this.pose) : [];
    const places = [...arm, ...this.room];
    return places.length > 0 ? overview(places, this.size, "oblique") : null;
  }

  private placeHandle(view: Viewpoint): void {
    const tool = this.toolMm;
    if (!this.withHandle || !tool) return this.scene.setHandle(null);
    const placeMm = this.heldMm ?? tool;
    const radiusMm = HANDLE_PX * onScreen(view, this.size, placeMm).mmPerPixel;
    this.scene.setHandle({ placeMm, radiusMm, toolMm: tool });
  }
}
