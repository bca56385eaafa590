// What the virtual hand shows: kept on the phone, so that all takes of a task are of one motion.
import { effect, signal } from "@preact/signals";
import type { HandScript } from "../api/types";

const KEY = "team.hand-script";
const SCRIPTS: readonly string[] = ["f1", "f2", "f3"] satisfies HandScript[];

export const handScript = signal<HandScript>(remembered());

effect(() => {
  try {
    localStorage.setItem(KEY, handScript.value);
  } catch {
    // Private browsing may refuse; the choice then lasts until the page is closed.
  }
});

function remembered(): HandScript {
  try {
    const stored = localStorage.getItem(KEY) ?? "";
    return SCRIPTS.includes(stored) ? (stored as HandScript) : "f1";
  } catch {
    return "f1";
  }
}
