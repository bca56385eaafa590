// Keeping, discarding and deleting, each with the way back for as long as the app is open.
import { signal } from "@preact/signals";
import * as api from "../api/endpoints";
import type { Demonstration, DemonstrationState, Task } from "../api/types";
import { demonstrations, tasks } from "./entities";

interface Decided {
  take: Demonstration;
  was: DemonstrationState;
}

/** What was decided last about a take; nothing when it was taken back. */
export const lastDecision = signal<Decided | null>(null);
/** The task that was deleted last. */
export const lastDeleted = signal<Task | null>(null);

export async function decide(take: Demonstration, action: "keep" | "discard"): Promise<void> {
  const decided = await api.closeDemonstration(take.id, action);
  demonstrations.put(decided);
  lastDecision.value = { take: decided, was: take.state };
}

export async function takeBack({ take, was }: Decided): Promise<void> {
  const before =
    was === "kept"
      ? await api.closeDemonstration(take.id, "keep")
      : was === "discarded"
        ? await api.closeDemonstration(take.id, "discard")
        : await api.undecide(take.id);
  demonstrations.put(before);
  lastDecision.value = null;
}

export async function deleteTask(task: Task): Promise<void> {
  await api.deleteTask(task.id);
  tasks.forget(task.id);
  lastDeleted.value = task;
}

export async function restoreTask(task: Task): Promise<void> {
  tasks.put(await api.restoreTask(task.id));
  lastDeleted.value = null;
}
