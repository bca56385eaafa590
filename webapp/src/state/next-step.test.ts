import { expect, test } from "vitest";
import type { Demonstration, DemonstrationState, Model } from "../api/types";
import { nextStep } from "./next-step";

const take = (id: string, state: DemonstrationState): Demonstration => ({
  id,
  task_id: "t",
  take: 1,
  state,
  source: "virtual_hand",
  created_at: "",
  duration_s: 5,
  samples: 500,
  rate_hz: 100,
  gaps: 0,
  usable: true,
});
const model = (state: Model["state"], demonstrations: string[]): Model => ({
  id: "m",
  task_id: "t",
  version: 1,
  state,
  job_id: "j",
  demonstrations,
  method: "paper",
  seed: 0,
  created_at: "",
});
const kept = ["a", "b", "c"].map((id) => take(id, "kept"));

test("record until three are kept, then train", () => {
  expect(nextStep([], [])).toEqual({ step: "record" });
  expect(nextStep(kept.slice(0, 2), []).step).toBe("record");
  expect(nextStep(kept, []).step).toBe("train");
  expect(nextStep([...kept.slice(0, 2), take("d", "discarded")], []).step).toBe("record");
});

test("an open recording comes first, then one that waits for a decision", () => {
  const undecided = take("d", "interrupted");
  expect(nextStep([...kept, undecided], [model("training", [])])).toMatchObject({
    step: "decide",
    take: undecided,
  });
  expect(nextStep([undecided, take("e", "recording")], []).step).toBe("recording");
});

test("the result is shown until other takes are kept", () => {
  expect(nextStep(kept, [model("training", ["a"])]).step).toBe("training");
  expect(nextStep(kept, [model("ready", ["c", "a", "b"])]).step).toBe("result");
  expect(nextStep([...kept, take("d", "kept")], [model("ready", ["a", "b", "c"])]).step).toBe(
    "train",
  );
  const cut = { from_s: 0.5, to_s: 4 };
  const anew = [{ ...take("a", "kept"), trim: cut }, ...kept.slice(1)];
  expect(nextStep(anew, [model("ready", ["a", "b", "c"])]).step).toBe("train");
  const fromCut = { ...model("ready", ["a", "b", "c"]), trims: [cut, null, null] };
  expect(nextStep(anew, [fromCut]).step).toBe("result");
  const [one] = anew;
  expect(nextStep([one!], [model("ready", ["a"])]).step).toBe("train");
  expect(nextStep(kept, [fromCut]).step).toBe("train");
  expect(nextStep(kept.slice(0, 1), [model("ready", ["a"])]).step).toBe("result");
  expect(nextStep(kept, [model("failed", ["a", "b", "c"])]).step).toBe("train");
});
