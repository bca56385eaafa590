// What the overview shows, asked for every other second while it is on the screen, and how old it is.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { getDashboard } from "../api/endpoints";
import { asProblem, type Problem } from "../api/problem";
import type { Dashboard } from "../api/types";

const EVERY_MS = 2000;
/** Older than this is said to be old: two answers in a row are missing then. */
export const OLD_AFTER_MS = 3 * EVERY_MS;

export const dashboard = signal<Dashboard | null>(null);
export const dashboardProblem = signal<Problem | null>(null);
/** How long ago the last answer came in, in milliseconds. */
export const dashboardAgeMs = signal(0);

let heardAtMs = 0;

/** Keeps asking until the screen is left. The next question waits for the answer to the last one. */
export function useDashboard(): void {
  useEffect(() => {
    let open = true;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const ask = async () => {
      try {
        const answer = await getDashboard();
        if (!open) return;
        heardAtMs = performance.now();
        dashboard.value = answer;
        dashboardProblem.value = null;
      } catch (error) {
        if (!open) return;
        dashboardProblem.value = asProblem(error);
      }
      grow();
      timer = setTimeout(ask, EVERY_MS);
    };
    const grow = () => {
      if (dashboard.peek()) dashboardAgeMs.value = performance.now() - heardAtMs;
    };
    const clock = setInterval(grow, 1000);
    void ask();
    return () => {
      open = false;
      clearTimeout(timer);
      clearInterval(clock);
    };
  }, []);
}
