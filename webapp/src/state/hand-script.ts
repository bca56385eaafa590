// Who leads the virtual arm: the person at the phone, or the virtual hand with one of its motions.
// Kept on the phone, so that all takes of a task are of one motion.
import { effect, signal } from "@preact/signals";
import type { HandScript } from "../api/types";

const KEY = "team.hand-script";
const SCRIPTS: readonly string[] = ["f1", "f2", "f3"] satisfies HandScript[];

/** "self" is the person, with a finger in the picture of the arm. */
export type Leader = HandScript | "self";

export const leader = signal<Leader>(remembered());

/** What the virtual hand shows; null when the person leads. */
export const handScript = (): HandScript | null => (leader.value === "self" ? null : leader.value);

effect(() => {
  try {
    localStorage.setItem(KEY, leader.value);
  } catch {
    // Private browsing may refuse; the choice then lasts until the page is closed.
  }
});

function remembered(): Leader {
  try {
    const stored = localStorage.getItem(KEY) ?? "";
    return SCRIPTS.includes(stored) ? (stored as HandScript) : "self";
  } catch {
    return "self";
  }
}
