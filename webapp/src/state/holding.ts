// Holding the button: says so again and again while it is held, and lets go at the first sign
// that nobody may be holding it any more.
import { effect } from "@preact/signals";
import { connection, hold, letGo, robot } from "./live";

/** The server counts silence of 180 ms as letting go. */
const EVERY_MS = 50;

/** Holds for this motion until the returned function is called, or until something ends it: the
 *  page is hidden or left (a call comes in, the phone is locked), another window has the focus, the
 *  connection is lost, or the server has not heard of it for a while. `ended` is told once, whatever
 *  ended it; only another press makes the arm go on. */
export function beginHolding(reproduction: string, ended: () => void): () => void {
  let held = true;
  const press = Date.now();
  /** Whether the server has taken this press for held. */
  let taken = false;
  const stop = () => {
    if (!held) return;
    held = false;
    clearInterval(timer);
    unwatch();
    window.removeEventListener("blur", stop);
    window.removeEventListener("pagehide", stop);
    document.removeEventListener("visibilitychange", stop);
    letGo();
    ended();
  };
  const say = () => {
    if (!hold(reproduction, press)) stop();
  };
  const timer = setInterval(say, EVERY_MS);
  let unwatch: () => void = () => undefined;
  window.addEventListener("blur", stop);
  window.addEventListener("pagehide", stop);
  document.addEventListener("visibilitychange", stop);
  unwatch = effect(() => {
    const seen = robot.value?.run?.held;
    const lapsed = taken && seen === false;
    taken ||= seen === true;
    if (connection.value !== "live" || lapsed) queueMicrotask(stop);
  });
  say();
  return stop;
}
