// The saved positions of the robot that this phone works with.
import * as api from "../api/endpoints";
import type { Position } from "../api/types";
import { t } from "../texts";
import { Collection } from "./collection";
import { robotId } from "./robots";

export const positions = new Collection<Position>();

export async function loadPositions(): Promise<void> {
  const robot = robotId.peek();
  positions.replace((one) => one.robot === robot, await api.listPositions(robot));
}

/** Those of this robot by name, as the server sorts them. */
export function ourPositions(): Position[] {
  const ours = positions.where((one) => one.robot === robotId.value);
  return ours.sort((one, other) => one.name.localeCompare(other.name));
}

/** A name that none of these has: with the first free number from how many there are. */
export function freeName(taken: readonly string[]): string {
  const lower = new Set(taken.map((name) => name.toLowerCase()));
  for (let number = taken.length + 1; ; number += 1) {
    const name = t.positions.newName(String(number));
    if (!lower.has(name.toLowerCase())) return name;
  }
}
