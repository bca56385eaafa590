// Leading the virtual arm by its tool: where a finger wants the flange goes over the live socket,
// at a steady pace while it is held, and so does the letting go.
import { signal } from "@preact/signals";
import type { DragRefused } from "../api/types";

/** The server takes at most 30 in a second. It is told again while the finger rests: a phone that
 *  falls silent lets go of the arm. */
export const EVERY_MS = 40;

/** Why the arm did not follow the last drag; null when it did. */
export const dragRefused = signal<DragRefused | null>(null);

/** Whether the last drag ended because the phone lost its connection. */
export const dragLost = signal(false);

export interface DragTarget {
  /** Middle of the flange in the frame of the robot's base. */
  tool_mm: readonly number[];
  /** How the flange is turned from where it was taken: about the axis with these parts in its own
   *  frame, by its length. */
  turn_deg?: readonly number[];
}

export class ArmDrag {
  private target: DragTarget | null = null;
  private pace: ReturnType<typeof setInterval> | undefined;

  /** `send` says whether there was a connection. */
  constructor(private readonly send: (message: object) => boolean) {}

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
    if (this.target === null || this.send({ type: "drag", ...this.target })) return;
    dragLost.value = true;
    this.end();
  }
}
