// Recordings as files, and tasks made from them over the interface: for specs in which teaching
// by the hand is not the point.
import assert from "node:assert/strict";
import { setTimeout } from "node:timers/promises";
import { BASE_URL } from "./phone.mjs";

const HEADER = "t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";

/** The arm swinging two joints for four seconds; `size` makes takes differ, `spoil` may damage a row. */
export function recording({ size = 1, spoil = (row) => row } = {}) {
  const rows = Array.from({ length: 401 }, (_, index) => {
    const time = index / 100;
    const swing = 10 * size * Math.sin((Math.PI * time) / 4);
    return spoil([time, swing, 8 + swing / 2, 24, 0, -45, 0], index).join(",");
  });
  return `${[HEADER, ...rows].join("\n")}\n`;
}

const TRAINING_MS = 300_000;

export async function get(path) {
  return (await fetch(new URL(`/api/v1${path}`, BASE_URL))).json();
}

export async function post(path, options) {
  const response = await fetch(new URL(`/api/v1${path}`, BASE_URL), { method: "POST", ...options });
  const text = await response.text();
  assert.ok(response.ok, `${path}: ${text}`);
  return text === "" ? null : JSON.parse(text);
}

export const json = (body) => ({
  body: JSON.stringify(body),
  headers: { "Content-Type": "application/json" },
});

/** A task with three kept takes. */
export async function taskFromFiles(name) {
  const task = await post("/tasks", json({ name }));
  for (const size of [0.96, 1, 1.05]) {
    const file = { body: recording({ size }), headers: { "Content-Type": "text/csv" } };
    const take = await post(`/tasks/${task.id}/demonstrations/upload?name=swing.csv`, file);
    await post(`/demonstrations/${take.id}/keep`);
  }
  return task;
}

/** A task whose motion is trained. */
export async function trainedTask(name) {
  const task = await taskFromFiles(name);
  const { job } = await post(`/tasks/${task.id}/models`, json({}));
  const end = Date.now() + TRAINING_MS;
  for (;;) {
    const now = await get(`/jobs/${job.id}`);
    if (now.state === "succeeded") return task;
    await setTimeout(100);
    assert.ok(Date.now() < end && now.state !== "failed", `${name} is not trained: ${now.state}`);
  }
}

/** Gives the server so many trainings that the next one has to wait for its turn. */
export async function keepTrainerBusy(trainings) {
  const tasks = [];
  for (let number = 1; number <= trainings; number += 1) {
    tasks.push(await taskFromFiles(`Busy ${number}`));
  }
  const started = await Promise.all(
    tasks.map((task) => post(`/tasks/${task.id}/models`, json({}))),
  );
  return async () => {
    for (const { job } of started) await post(`/jobs/${job.id}/cancel`);
  };
}
