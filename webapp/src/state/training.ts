// Beginning a training, and running what came of it: each one press.
import { trainModel } from "../api/endpoints";
import { jobs, models } from "./entities";
import { useAction, type Action } from "./hooks";
import { go } from "./navigation";
import { previewAsTaught } from "./run-setup";

/** Begins to train from the kept takes and shows it. */
export async function train(task: string, replace = false): Promise<void> {
  const answer = await trainModel(task);
  jobs.put(answer.job);
  models.put(answer.model);
  go({ page: "model", task, model: answer.model.id }, replace);
}

/** From a model straight to the preview of the motion as it was taught. */
export function useRunAsTaught(task: string, model: string): Action {
  return useAction(async () => {
    await previewAsTaught(task, model);
    go({ page: "preview", task });
  });
}
