// How well the takes of a task agree, as the server finds it; asked again whenever a take is closed,
// kept or discarded.
import { signal } from "@preact/signals";
import { getAgreement } from "../api/endpoints";
import type { Demonstration, TaskAgreement } from "../api/types";
import { demonstrations } from "./entities";
import { useLoad, type Load } from "./hooks";

/** The latest answer for each task. */
const answers = signal<ReadonlyMap<string, Answer>>(new Map());

interface Answer {
  agreement: TaskAgreement;
  /** How the takes were cut when it was asked for. */
  cuts: string;
}

export interface Compared {
  /** Null until there is an answer about just these takes. */
  agreement: TaskAgreement | null;
  load: Load;
}

/** Whether a take is compared with the others: it is complete, and nobody discarded it. */
export function counts(take: Demonstration): boolean {
  return take.state === "recorded" || take.state === "kept";
}

/** Whether an answer is about the takes as they are now. Takes that this phone has not loaded may
 *  be in it. */
export function fits(agreement: TaskAgreement, takes: readonly Demonstration[]): boolean {
  const answered = new Set(agreement.takes.map((take) => take.id));
  return takes.every((take) => counts(take) === answered.has(take.id));
}

/** The stretches of the takes that are compared. */
function cutsOf(takes: readonly Demonstration[]): string {
  const cut = takes.filter((take) => counts(take) && take.trim);
  return cut
    .map((take) => `${take.id} ${take.trim?.from_s} ${take.trim?.to_s}`)
    .sort()
    .join(" ");
}

const takesOf = (task: string) => demonstrations.where((take) => take.task_id === task);

export function useAgreement(task: string): Compared {
  const takes = takesOf(task);
  const key = takes.filter(counts).map((take) => take.id);
  const cuts = cutsOf(takes);
  const load = useLoad(
    async () => {
      const agreement = await getAgreement(task);
      const now = takesOf(task);
      // An answer that was overtaken by another take must not replace the one about it.
      if (fits(agreement, now) && cutsOf(now) === cuts)
        answers.value = new Map(answers.peek()).set(task, { agreement, cuts });
    },
    [task, cuts, ...key.sort()].join(" "),
  );
  const answer = answers.value.get(task);
  const holds = answer && answer.cuts === cuts && fits(answer.agreement, takes);
  return { agreement: holds ? answer.agreement : null, load };
}
