// Leading the virtual arm by its tool: where a finger wants the flange goes over the live socket,
// at a steady pace while it is held, and so does the letting go.
import { signal } from "@preact/signals";
import type { Vec3 } from "../arm3d/vector";
import type { DragMessage, LiveMessage } from "../api/types";

/** 25 a second. The server is told again while the finger rests: a phone that falls silent lets go
 *  of the arm. */
export const EVERY_MS = 40;

type DragRefused = Extract<LiveMessage, { type: "drag_refused" }>;

/** Why the arm did not follow the last drag; null when it did. */
export const dragRefused = signal<DragRefused | null>(null);

/** Whether the last drag ended because the phone lost its connection. */
export const dragLost = signal(false);

/** Where the flange shall be, and how it shall be turned from where it was taken. */
export interface DragTarget {
  tool_mm: Vec3;
  turn_deg?: Vec3;
}

export class ArmDrag {
  private target: DragTarget | null = null;
  private pace: ReturnType<typeof setInterval> | undefined;

  /** `send` says whether there was a connection. */
  constructor(private readonly send: (message: DragMessage) => boolean) {}

  get held(): boolean {
    return this.pace !== undefined;
  }

  begin(): void {
    if (this.held) return;
    dragRefused.value = null;
    dragLost.value = false;
    this.pace = setInterval(() => this.tell(), EVERY_MS);
  }

  /** What is wanted now. Between two messages the last one counts. */
  move(target: DragTarget): void {
    if (!this.held) return;
    const first = this.target === null;
    this.target = target;
    if (first) this.tell();
  }

  end(): void {
    if (!this.held) return;
    clearInterval(this.pace);
    this.pace = undefined;
    if (this.target !== null) this.send({ type: "drag_end" });
    this.target = null;
  }

  private tell(): void {
    if (this.target === null || this.send(messageOf(this.target))) return;
    dragLost.value = true;
    this.end();
  }
}

const messageOf = ({ tool_mm, turn_deg }: DragTarget): DragMessage => ({
  type: "drag",
  tool_mm: [...tool_mm],
  ...(turn_deg ? { turn_deg: [...turn_deg] } : {}),
});
