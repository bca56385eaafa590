// What a worker does in the app, by the names that are on the screen.
import assert from "node:assert/strict";
import { inspect } from "./layout.mjs";
import { openApp, until } from "./phone.mjs";

const TRAINING_MS = 300_000;
const MOTION_MS = 180_000;

export const button = (page, name) => page.getByRole("button", { name, exact: true });
export const linkNamed = (page, name) => page.getByRole("link", { name, exact: true });
export const heading = (page, name) => page.getByRole("heading", { name, exact: true, level: 1 });

/** The robot is connected and stands ready. */
export async function robotReady(page) {
  await page.getByRole("region", { name: "Robot" }).getByText("Ready", { exact: true }).waitFor();
}

export async function newTask(page, name) {
  await openApp(page);
  await linkNamed(page, "New task").click();
  await page.getByLabel("Name of the task").fill(name);
  await inspect(page, "teach-new-task");
  await button(page, "Create task").click();
  // A new task leads straight to its first recording; its own page is one step back.
  await heading(page, "Record a take").waitFor();
  await linkNamed(page, "Back").click();
  await heading(page, name).waitFor();
}

/** From the task's page into a running recording. */
export async function startRecording(page, { script = "Pick and place" } = {}) {
  await page.getByRole("link", { name: /^(Record a|Another) take$/ }).click();
  await heading(page, "Record a take").waitFor();
  await page.getByRole("radio", { name: new RegExp(`^${script}`) }).check();
  await robotReady(page);
  await inspect(page, "teach-record");
  await button(page, "Record").click();
  await page.getByText("The arm goes soft in").waitFor();
  await inspect(page, "teach-count-in");
  await page.getByRole("timer").waitFor();
}

/** The time that the recording screen shows. */
async function recordedSeconds(page) {
  return Number.parseFloat(await page.getByRole("timer").innerText());
}

/** Waits until the virtual hand is done, looks at the take and keeps it. */
export async function keepTake(page) {
  await button(page, "Keep").waitFor();
  await page.getByRole("img", { name: /^Recorded joint angles/ }).waitFor();
  await inspect(page, "teach-review");
  await button(page, "Keep").click();
  await page.getByRole("heading", { name: "Takes" }).waitFor();
}

export async function recordTake(page, options) {
  await startRecording(page, options);
  await until(page, "the traces show something", async () => (await recordedSeconds(page)) >= 2);
  await inspect(page, "teach-recording");
  await keepTake(page);
}

/** From a task with enough takes to its trained motion. */
export async function train(page) {
  await button(page, "Train").click();
  const learned = heading(page, "The arm has learned the motion");
  // A quick computer may be done before the progress was ever seen.
  await page.getByRole("progressbar", { name: "Training" }).or(learned).waitFor();
  await inspect(page, "teach-training");
  await learned.waitFor({ timeout: TRAINING_MS });
}

/** From a trained motion to the choices of a run, past the plan as it was taught. */
export async function runSetup(page) {
  await button(page, "Run it").click();
  await heading(page, "Planned motion").waitFor();
  await linkNamed(page, "Change").click();
  await page.getByText("Where shall it end?").waitFor();
}

/** From the choices of a run to its plan. */
export async function preview(page) {
  await button(page, "Preview").click();
  await heading(page, "Planned motion").waitFor();
  await page.getByRole("img", { name: /^Planned joint angles/ }).waitFor();
}

/** Starts a motion that runs by itself. */
export async function startMotion(page) {
  await robotReady(page);
  await page.getByRole("radio", { name: /^By itself/ }).check();
  await button(page, "Start").click();
  await heading(page, "The arm is moving").waitFor();
}

/** Gets the arm ready for a motion that moves only while the button is held. */
export async function getReady(page) {
  await robotReady(page);
  await button(page, "Get ready").click();
  await heading(page, "The arm waits for you").waitFor();
}

/** Presses the hold button with a finger (or mouse) that stays; `page.mouse.up()` lets go. */
export async function hold(page) {
  const place = await button(page, "Hold to move").boundingBox();
  await page.mouse.move(place.x + place.width / 2, place.y + place.height / 2);
  await page.mouse.down();
  await heading(page, "The arm is moving").waitFor();
}

/** The arm goes all the way. */
export async function motionDone(page) {
  await heading(page, "Goal reached").waitFor({ timeout: MOTION_MS });
  await page.getByRole("img", { name: /^Planned and measured/ }).waitFor();
}

/** The value beside a name in a list of figures. */
export async function figure(page, name) {
  const value = page.locator("dl.figures > div").filter({ hasText: name }).locator("dd");
  return (await value.innerText()).trim();
}

/** A figure as a number, without its unit. */
export async function figureNumber(page, name) {
  const text = await figure(page, name);
  const number = Number(/[−-]?[\d.]+/.exec(text)?.[0].replace("−", "-"));
  assert.ok(Number.isFinite(number), `${name}: ${text}`);
  return number;
}
