// The states of the live connection and which may follow which. No socket here.

export type ConnectionState = "connecting" | "identifying" | "live" | "lost";

/** `identifying`: the socket is open, the snapshot that says where everything stands is not here
 *  yet. Nothing is live before it, so a reconnect never mixes old state with new. */
const ALLOWED: Record<ConnectionState, readonly ConnectionState[]> = {
  connecting: ["identifying", "lost"],
  identifying: ["live", "lost"],
  live: ["lost"],
  lost: ["connecting"],
};

export function mayFollow(from: ConnectionState, to: ConnectionState): boolean {
  return ALLOWED[from].includes(to);
}

export const FIRST_DELAY_MS = 500;
export const LONGEST_DELAY_MS = 5000;
export const SILENCE_MS = 3000;

/** By how much a wait may be longer than another one: phones that lost the server together do not
 *  come back together. */
const SPREAD = 0.3;

/** How long to wait before trial number `attempt` (from 0) after the connection was lost; `chance`
 *  is from 0 to 1. */
export function backOffMs(attempt: number, chance: number): number {
  const delay = Math.min(FIRST_DELAY_MS * 1.4 ** attempt, LONGEST_DELAY_MS);
  return delay * (1 + SPREAD * chance);
}
