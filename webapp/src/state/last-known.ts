// What this phone heard of its robot last, kept for a start without the server. It is for reading
// only, and always shown with its age.
import type { RobotView } from "../api/types";
import { recall, remember } from "./browser-store";
import { ownFile } from "./build";

const KEY = "team.last-known";
/** The robot speaks many times a second; once is enough to know later where it stood. */
const EVERY_MS = 1000;

export interface LastKnown {
  view: RobotView;
  atMs: number;
}

let writtenMs = 0;

export function keepRobot(view: RobotView, atMs: number): void {
  if (Math.abs(atMs - writtenMs) < EVERY_MS) return;
  writtenMs = atMs;
  remember(KEY, JSON.stringify({ build: ownFile(), view, atMs }));
}

/** Nothing when there is none, or when another build wrote it, whose shapes may differ. */
export function lastKnown(nowMs: number): LastKnown | null {
  try {
    const kept = JSON.parse(recall(KEY) ?? "null") as (LastKnown & { build: string }) | null;
    if (kept === null || kept.build !== ownFile()) return null;
    // A clock that was set back makes nothing younger than just now.
    return { view: kept.view, atMs: Math.min(kept.atMs, nowMs) };
  } catch {
    return null;
  }
}
