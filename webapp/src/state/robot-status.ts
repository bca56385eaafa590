// What the bar on top says about the robot. Pure: everything it depends on comes in.
import type { RobotView } from "../api/types";
import type { ConnectionState } from "../live/connection";
import { age } from "../format/numbers";
import { t } from "../texts";
import { phoneId } from "./phone";

export type Tone = "good" | "moving" | "soft" | "bad" | "stale";
export type StatusIcon = "check" | "hand" | "move" | "stop" | "alert" | "unplugged" | "clock";

export interface RobotStatus {
  tone: Tone;
  icon: StatusIcon;
  word: string;
  age: string;
  stale: boolean;
}

/** Joints older than this are shown as old, whatever the connection says. */
export const STALE_AFTER_MS = 1500;

const LOOKS: Record<RobotView["state"], [Tone, StatusIcon]> = {
  disconnected: ["stale", "unplugged"],
  idle: ["good", "check"],
  guiding: ["soft", "hand"],
  reproducing: ["moving", "move"],
  stopping: ["moving", "stop"],
  faulted: ["bad", "alert"],
};

export function robotStatus(
  view: RobotView | null,
  connection: ConnectionState,
  sinceMessageMs: number,
): RobotStatus {
  const unknown = connection === "lost" ? t.robot.states.unknown : t.robot.connecting;
  const known = view?.kind === "none" ? "none" : view?.state;
  const word = known ? t.robot.states[known] : unknown;
  if (view === null) {
    return { tone: "stale", icon: "clock", word, age: "", stale: true };
  }
  const ageMs = view.age_ms + Math.max(0, sinceMessageMs);
  if (connection !== "live") {
    const old = t.robot.ago(word, age(ageMs));
    return { tone: "stale", icon: "unplugged", word: t.robot.offline, age: old, stale: true };
  }
  const [tone, icon] = LOOKS[view.state];
  if (view.state === "disconnected") return { tone, icon, word, age: "", stale: true };
  if (ageMs > STALE_AFTER_MS) {
    return { tone: "stale", icon: "clock", word, age: t.robot.old(age(ageMs)), stale: true };
  }
  return { tone, icon, word, age: t.robot.now, stale: false };
}

/** The name of the other phone that controls the robot; null when this one may. */
export function controlledByOther(view: RobotView): string | null {
  const { phone } = view.control ?? {};
  return phone && phone.id !== phoneId ? phone.name : null;
}

/** Why the arm cannot be asked to do something now; null when it can. */
export function whyNotReady(
  view: RobotView | null,
  connection: ConnectionState,
  softIsFine = false,
): string | null {
  if (connection !== "live" || view === null) return t.robot.why.offline;
  const other = controlledByOther(view);
  if (other !== null) return t.control.other(other);
  if (view.state === "idle" || (softIsFine && view.state === "guiding")) return null;
  return t.robot.why[view.state];
}
