// Whether this phone may use the robot, and the pairing that lets it.
import { computed, signal } from "@preact/signals";
import * as api from "../api/endpoints";
import { whenUnauthorised } from "../api/client";
import type { Session } from "../api/types";
import { pairingCode } from "../router";
import { takeCode } from "./joining";
import { go } from "./navigation";
import { loadRobots } from "./robots";

export const session = signal<Session | null>(null);

export const mustPair = computed(
  () => session.value !== null && session.value.pairing_required && !session.value.paired,
);

export async function loadSession(): Promise<void> {
  const known = await api.getSession();
  // Nothing is shown before it is known which robot it is about.
  if (known.paired) await loadRobots();
  session.value = known;
}

export async function pair(code: string): Promise<void> {
  await api.pair(code);
  await loadSession();
}

/** Loads the session; a code in the address (from the QR code) pairs without typing. The code is
 *  taken out of the address at once, so that it is not left in the history. */
export async function beginSession(): Promise<void> {
  whenUnauthorised(() => {
    const known = session.peek();
    if (known?.paired) session.value = { ...known, paired: false };
  });
  takeCode();
  const code = pairingCode(location.hash);
  if (code !== null) go({ page: "teach" }, true);
  await loadSession();
  if (code !== null && mustPair.peek()) await pair(code);
}
