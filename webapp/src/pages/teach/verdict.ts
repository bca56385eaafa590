// A training judged in one word: whether the motion can be used.
import type { Model } from "../../api/types";
import type { IconName } from "../../components/icon";
import type { NoticeTone } from "../../components/notice";
import { t } from "../../texts";

export type Light = "green" | "amber" | "red";

export interface Verdict {
  light: Light;
  word: string;
  sentence: string;
}

/** Colour is never alone: each light has a sign of its own shape. */
export const LIGHTS: Record<Light, { tone: NoticeTone; icon: IconName }> = {
  green: { tone: "good", icon: "check" },
  amber: { tone: "soft", icon: "alert" },
  red: { tone: "bad", icon: "cross" },
};

/** So much further than the takes are from each other, and so far, nobody wants the path. */
const FAR_RATIO = 2;
const FAR_MM = 10;
/** An arm that ends so far from its goal misses it. */
const MISSED_DEG = 1;
/** Below this likeness it is another motion. */
const UNLIKE = 0.9;

export function verdictOf({ report, demonstrations }: Model): Verdict {
  const { red, amber, green } = t.teaching.verdict;
  const say = (light: Light, sentence: string): Verdict => ({
    light,
    word: t.teaching.verdict[light].word,
    sentence,
  });
  const ratio = report?.fidelity?.missed_over_mutual ?? 0;
  const missedMm = report?.fidelity?.missed_mean_mm ?? 0;
  if ((report?.e_j_deg ?? 0) > MISSED_DEG) return say("red", red.goal);
  if ((report?.gmcc ?? 1) < UNLIKE) return say("red", red.shape);
  if (ratio > FAR_RATIO && missedMm > FAR_MM) return say("red", red.far);
  if (ratio > 1) return say("amber", amber.far);
  if (demonstrations.length < 2) return say("amber", amber.few);
  if (report?.agreement?.enough === false) return say("amber", amber.disagree);
  return say("green", green.sentence);
}
