// The robots of the cell, and which of them this phone works with. The phone remembers it.
import { signal } from "@preact/signals";
import * as api from "../api/endpoints";
import type { RobotView } from "../api/types";

const REMEMBERED = "team-robot";

/** As they were when they were asked for last. */
export const robots = signal<readonly RobotView[]>([]);
/** The robot that everything on this phone is about; empty until it is known which. */
export const robotId = signal("");

/** Asks for the robots. With only one there is nothing to choose; with several the phone goes on
 *  with the one that it remembers, and never with another one by itself. */
export async function loadRobots(): Promise<void> {
  const list = await api.listRobots();
  robots.value = list;
  if (list.some((one) => one.id === robotId.peek())) return;
  const [only] = list;
  const known = list.length === 1 ? only : list.find((one) => one.id === remembered());
  robotId.value = known?.id ?? "";
}

/** A person says which robot this phone stands at. */
export function chooseRobot(id: string): void {
  robotId.value = id;
  try {
    localStorage.setItem(REMEMBERED, id);
  } catch {
    // A browser that keeps nothing asks again after a reload.
  }
}

function remembered(): string | null {
  try {
    return localStorage.getItem(REMEMBERED);
  } catch {
    return null;
  }
}

/** Whether this is this robot's; what does not say is from a time with one robot only. */
export function isOurs(thing: { robot?: string | null }): boolean {
  return thing.robot == null || thing.robot === robotId.value;
}
