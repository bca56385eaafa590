// A server's content with something of everything, made over the interface within a minute; and
// what passes by quickly (a recording, a training, a motion), as the server told it at that moment.
import assert from "node:assert/strict";
import { eventually, get, patch, post, put, upload } from "./api.mjs";
import { recording } from "./files.mjs";

/** What the tasks are called on screenshots, so that a page is of one language. */
const NAMES = {
  en: ["Load the drilling machine", "Put on the lid", "Place the part"],
  de: ["Bohrmaschine beladen", "Deckel aufsetzen", "Teil ablegen"],
  fr: ["Charger la perceuse", "Poser le couvercle", "Déposer la pièce"],
  it: ["Caricare il trapano", "Mettere il coperchio", "Posare il pezzo"],
};

export async function makeWorld() {
  await eventually("the arm is idle", "/robots/virtual", (robot) => robot.state === "idle");
  const made = [];
  for (const name of NAMES.en) made.push((await post("/tasks", { name })).id);
  const [drill, lid, part] = made;
  const tasks = { drill, lid, part };
  const shown = await record(tasks.drill);
  const training = await train(tasks.drill);
  const odd = await differing(tasks.lid);
  const motion = await move(training.model);
  const stopped = await moveAndStop(training.model);
  await speak(tasks.drill, motion.motion, stopped);
  // The server may have seen a world before, and a name is taken once.
  const saved = await get("/positions");
  if (saved.length === 0) await post("/positions", { robot: "virtual", name: "Fixture" });
  return { tasks, ...shown, ...training, ...odd, ...motion, stopped };
}

/** Names the tasks in this language. */
export async function nameTasks(world, language) {
  const names = NAMES[language] ?? NAMES.en;
  for (const [place, task] of Object.values(world.tasks).entries()) {
    await patch(`/tasks/${task}`, { name: names[place] });
  }
}

/** Three takes by the virtual hand. */
async function record(task) {
  const start = (seed) =>
    post(`/tasks/${task}/demonstrations`, { robot: "virtual", virtual_hand: "f1", seed });
  const keep = async (id) => {
    await eventually("it is recorded", `/demonstrations/${id}`, (now) => now.state === "recorded");
    await post(`/demonstrations/${id}/keep`);
    await eventually("the arm is idle", "/robots/virtual", (robot) => robot.state === "idle");
  };
  const preparingTake = await start(1);
  const { id } = preparingTake;
  const recordingTake = await eventually(
    "the take is being recorded",
    `/demonstrations/${id}`,
    (now) => now.state === "recording" && now.duration_s > 1,
  );
  const guidingRobot = await get("/robots/virtual");
  await keep(id);
  for (const seed of [2, 3]) await keep((await start(seed)).id);
  return {
    preparingTake: { ...preparingTake, state: "preparing" },
    recordingTake: { ...recordingTake, duration_s: 6.4 },
    guidingRobot,
    trajectory: await get(`/demonstrations/${id}/trajectory?max_points=900`),
    take: id,
  };
}

async function train(task) {
  const { job, model } = await post(`/tasks/${task}/models`, {});
  const seen = await eventually(
    "the training is under way or done",
    `/jobs/${job.id}`,
    (now) => now.progress.fraction > 0.3 || now.state === "succeeded",
  );
  const trainingModel = model;
  await eventually("it is trained", `/models/${model.id}`, (now) => now.state === "ready");
  const trainingJob = { ...seen, state: "running", progress: { ...seen.progress, fraction: 0.62 } };
  return { model: model.id, trainingModel, trainingJob };
}

/** Two takes that agree, one that does not, and one that waits for a decision. */
async function differing(task) {
  const spoil = (row) => row.with(5, -45 + 16 * Math.sin((Math.PI * row[0]) / 4));
  const files = [{ size: 0.97 }, { size: 1.02 }, { spoil }];
  const takes = [];
  for (const options of files) takes.push(await upload(task, "swing.csv", recording(options)));
  for (const take of takes) await post(`/demonstrations/${take.id}/keep`);
  const waiting = await upload(task, "swing.csv", recording({ size: 1.04 }));
  return { oddTake: takes[2].id, waitingTake: waiting.id };
}

/** What people said of the runs, some of them in the questionnaire. */
async function speak(task, motion, stopped) {
  await put(`/reproductions/${motion}/outcome`, { worked: true });
  await put(`/reproductions/${stopped}/outcome`, { worked: false, note: "The part slipped." });
  for (const answers of [
    [5, 4, 4, 5, 4],
    [4, 5, 3, 4, 4],
    [5, 3, 4, 4, 5],
  ]) {
    const person = crypto.randomUUID();
    await post("/questionnaire", { person, task_id: task, reproduction_id: motion, answers });
  }
}

const plan = (model, speed) =>
  post("/plans", { model_id: model, start: "as_taught", goal: "as_taught", speed });

async function begin(model, speed) {
  await eventually("the arm is idle", "/robots/virtual", (robot) => robot.state === "idle");
  const { plan: hash } = await plan(model, speed);
  const started = await post("/reproductions", { plan: hash });
  const movingRobot = await eventually(
    "the motion is under way",
    "/robots/virtual",
    (robot) => robot.run?.phase === "motion" && robot.run.t_s > 0.35 * robot.run.duration_s,
  );
  const movingMotion = await get(`/reproductions/${started.id}`);
  return { movingRobot, movingMotion };
}

/** A motion to its goal. On a machine that is too busy for the control loop the arm stops with a
 *  fault, as it should; a person acknowledges that and starts again. */
async function move(model, trials = 3) {
  const seen = await begin(model, 1);
  const path = `/reproductions/${seen.movingMotion.id}`;
  const end = await eventually("it has ended", path, (now) => now.state !== "running");
  if (end.state === "succeeded") return { ...seen, motion: end.id };
  assert.ok(trials > 1, `the motion fails: ${end.reason}`);
  await post("/robots/virtual/reset");
  return move(model, trials - 1);
}

async function moveAndStop(model) {
  const { movingMotion } = await begin(model, 0.5);
  await post("/robots/virtual/stop");
  const path = `/reproductions/${movingMotion.id}`;
  await eventually("it is stopped", path, (now) => now.state !== "running");
  return movingMotion.id;
}
