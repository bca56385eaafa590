// Keeps the screen on while something goes on that a person must see. Browsers give this to HTTPS
// pages only, take it away when the page is hidden, and some give it only right after a touch.
import { useEffect } from "preact/hooks";

/** From one screen to the next the lock is kept, since a new one might want a new touch. */
const LINGER_MS = 2000;

let wanted = 0;
let lock: WakeLockSentinel | null = null;
let asking = false;
let release: ReturnType<typeof setTimeout> | undefined;

/** The screen stays on as long as this is called with true. */
export function useWakeLock(active: boolean): void {
  useEffect(() => {
    if (!active) return;
    hold();
    return letGo;
  }, [active]);
}

/** Whether this browser can keep the screen on here. */
export function canStayAwake(): boolean {
  return "wakeLock" in navigator;
}

function hold(): void {
  wanted += 1;
  clearTimeout(release);
  if (wanted === 1) {
    document.addEventListener("visibilitychange", ask);
    document.addEventListener("pointerup", ask);
  }
  ask();
}

function letGo(): void {
  wanted -= 1;
  if (wanted > 0) return;
  document.removeEventListener("visibilitychange", ask);
  document.removeEventListener("pointerup", ask);
  clearTimeout(release);
  release = setTimeout(drop, LINGER_MS);
}

/** Asks for the lock if it is wanted and not there: at first, when the page is seen again, and with
 *  the next touch after a refusal. */
function ask(): void {
  if (wanted === 0 || asking || !canStayAwake()) return;
  if ((lock && !lock.released) || document.visibilityState !== "visible") return;
  asking = true;
  navigator.wakeLock
    .request("screen")
    .then(
      (given) => {
        lock = given;
        if (wanted === 0) drop();
      },
      () => undefined,
    )
    .finally(() => (asking = false));
}

function drop(): void {
  lock?.release().catch(() => undefined);
  lock = null;
}
