// What a task needs next: the one thing its page puts forward.
import type { Demonstration, Model } from "../api/types";

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
  const kept = takes.filter((take) => take.state === "kept").map((take) => take.id);
  const trained = models.find(
    (model) => model.state === "ready" && sameSet(model.demonstrations, kept),
  );
  if (trained) return { step: "result", model: trained };
  return kept.length >= ENOUGH_TAKES ? { step: "train" } : { step: "record" };
}

function sameSet(left: readonly string[], right: readonly string[]): boolean {
  return left.length === right.length && left.every((id) => right.includes(id));
}
