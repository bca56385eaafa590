// What a task needs next: the one thing its page puts forward.
import type { Demonstration, Model, Trim } from "../api/types";

export const ENOUGH_TAKES = 3;

export type NextStep =
  | { step: "recording"; take: Demonstration }
  | { step: "decide"; take: Demonstration }
  | { step: "training"; model: Model }
  | { step: "record" }
  | { step: "train" }
  | { step: "result"; model: Model };

export function nextStep(takes: readonly Demonstration[], models: readonly Model[]): NextStep {
  const open = takes.find((take) => take.state === "preparing" || take.state === "recording");
  if (open) return { step: "recording", take: open };
  const undecided = takes.find((take) => take.state === "recorded" || take.state === "interrupted");
  if (undecided) return { step: "decide", take: undecided };
  const training = models.find((model) => model.state === "training");
  if (training) return { step: "training", model: training };
  const kept = takes.filter((take) => take.state === "kept");
  const trained = models.findLast((model) => model.state === "ready" && isFrom(model, kept));
  if (trained) return { step: "result", model: trained };
  // The same takes, cut otherwise than when they were trained.
  const isCutAnew = models.some(
    (model) => model.state === "ready" && isFrom({ ...model, trims: trimsOf(model, kept) }, kept),
  );
  return isCutAnew || kept.length >= ENOUGH_TAKES ? { step: "train" } : { step: "record" };
}

/** Whether a model was trained from just these takes, cut as they are now. */
export function isFrom(model: Model, kept: readonly Demonstration[]): boolean {
  return (
    model.demonstrations.length === kept.length &&
    model.demonstrations.every((id, position) => {
      const take = kept.find((one) => one.id === id);
      return take !== undefined && isSameTrim(take.trim, model.trims?.[position]);
    })
  );
}

/** How the takes of a model are cut now. */
function trimsOf({ demonstrations }: Model, kept: readonly Demonstration[]): (Trim | null)[] {
  return demonstrations.map((id) => kept.find((take) => take.id === id)?.trim ?? null);
}

function isSameTrim(one?: Trim | null, other?: Trim | null): boolean {
  return one?.from_s === other?.from_s && one?.to_s === other?.to_s;
}
