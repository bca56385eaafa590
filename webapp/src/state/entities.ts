// All that the app knows from the server besides the robot itself.
import type { Demonstration, Job, Model, Reproduction, Task } from "../api/types";
import * as api from "../api/endpoints";
import { Collection } from "./collection";

export const tasks = new Collection<Task>();
export const demonstrations = new Collection<Demonstration>();
export const models = new Collection<Model>();
export const jobs = new Collection<Job>();
export const reproductions = new Collection<Reproduction>();

export async function loadTasks(): Promise<void> {
  tasks.replace(() => true, await api.listTasks());
}

/** All tasks with how far each is. */
export async function loadOverview(): Promise<void> {
  await loadTasks();
  const all = tasks.where(() => true);
  await Promise.all(all.flatMap((task) => [loadDemonstrations(task.id), loadModels(task.id)]));
}

export async function loadTask(task: string): Promise<void> {
  tasks.put(await api.getTask(task));
}

export async function loadDemonstrations(task: string): Promise<void> {
  const list = await api.listDemonstrations(task);
  demonstrations.replace((item) => item.task_id === task, list);
}

export async function loadDemonstration(id: string): Promise<void> {
  demonstrations.put(await api.getDemonstration(id));
}

export async function loadModels(task: string): Promise<void> {
  models.replace((item) => item.task_id === task, await api.listModels(task));
}

/** A model and, while it is being trained, the job that does it. */
export async function loadModel(id: string): Promise<void> {
  const model = await api.getModel(id);
  if (model.state === "training") jobs.put(await api.getJob(model.job_id));
  models.put(model);
}

export async function loadReproduction(id: string): Promise<void> {
  reproductions.put(await api.getReproduction(id));
}

/** A task with its takes and models: what its page needs. */
export async function loadAllOf(task: string): Promise<void> {
  await Promise.all([loadTask(task), loadDemonstrations(task), loadModels(task)]);
}

/** The newest model that can be run. */
export function readyModel(task: string): Model | undefined {
  return models
    .where((model) => model.task_id === task && model.state === "ready")
    .reduce<Model | undefined>(
      (best, model) => (best && best.version > model.version ? best : model),
      undefined,
    );
}
