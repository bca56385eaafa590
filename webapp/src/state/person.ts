// Who uses this phone, as far as the questionnaire needs it: a random identifier that the phone
// makes for itself and keeps. Nothing leads from it to a name.
import { signal } from "@preact/signals";
import { newId } from "../api/ids";

const REMEMBERED = "team.person";

let made: string | null = null;

/** The identifier of whoever uses this phone. */
export function person(): string {
  made ??= remembered() ?? newId();
  try {
    localStorage.setItem(REMEMBERED, made);
  } catch {
    // A browser that keeps nothing has another person each time it is opened.
  }
  return made;
}

function remembered(): string | null {
  try {
    const stored = localStorage.getItem(REMEMBERED);
    return stored && /^[0-9a-f-]{36}$/.test(stored) ? stored : null;
  } catch {
    return null;
  }
}

/** Motions after which this person answered or declined: the invitation goes at once. */
export const settled = signal<ReadonlySet<string>>(new Set());

export function settle(motion: string): void {
  settled.value = new Set(settled.peek()).add(motion);
}
