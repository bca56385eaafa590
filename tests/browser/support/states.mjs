// Every page and state of the app and how to reach it, in any language: by its address, by what the
// server is staged to say, and by what is pressed (found by its place, never by its words).
import { recording } from "./files.mjs";
import { curveOf, openStages } from "./stage.mjs";

/** The takes were compared, and the picture of the last is drawn. */
const compared = "main:has(.notice:not(.tone-plain) .advice) li:last-child .sparkline path";
/** The identity of the phone that looks at the states. */
export const OWN_PHONE = "0198c0de-0000-7000-8000-000000000001";
const primary = (page) => page.locator(".actions .button-primary");
const top = (page, selector) =>
  page.locator(selector).evaluate((element) => element.scrollIntoView({ block: "start" }));

const FAULT = {
  code: "robot_not_ready",
  message: "the motors cannot be switched on: an emergency stop is active",
  advice: "Release the stop and acknowledge it on the controller.",
};

/** All states of a world. Each has a `name`, an `at` (the address), `shows` (a selector that is on
 *  the screen when it is there), and perhaps a `stage` and a `then` (what is done on the page). */
export function statesOf(world) {
  const { tasks } = world;
  const curve = curveOf(world.trajectory);
  const idle = {
    ...world.guidingRobot,
    state: "idle",
    lead_through: false,
    hand: null,
    control: null,
  };
  const task = `#/teach/${tasks.drill}`;
  const takeAt = (take) => `#/teach/${take.task_id}/takes/${take.id}`;
  const taking = (take, robot) => ({
    answers: { [`/demonstrations/${take.id}`]: take },
    live: { robot, demonstration: take },
    curve,
  });
  const learning = (state) => {
    const job = { ...world.trainingJob, state };
    const model = { ...world.trainingModel, state: "training" };
    return {
      answers: { [`/models/${model.id}`]: model, [`/jobs/${job.id}`]: job },
      live: { robot: idle, jobs: [job] },
    };
  };
  const moving = (change) => {
    const robot = world.movingRobot;
    const running = { ...world.movingMotion, state: "running" };
    return {
      answers: { [`/reproductions/${running.id}`]: running },
      live: { robot: { ...robot, run: { ...robot.run, ...change } }, reproduction: running },
      curve,
    };
  };
  const cell = [
    { ...idle, name: "Left arm" },
    { ...idle, id: "right", name: "Right arm", state: "guiding" },
  ];
  const motionAt = `#/run/${tasks.drill}/motions/`;
  const typed = async (page) => {
    await page.locator("input[type=radio][value=typed]").check();
    await page.locator(".joint-inputs").waitFor();
  };
  return [
    { name: "teach", at: "#/teach", shows: ".row .tone-good" },
    { name: "teach-empty", at: "#/teach", shows: "main p", stage: { answers: { "/tasks": [] } } },
    { name: "teach-new-task", at: "#/teach/new", shows: ".field input" },
    { name: "teach-task", at: task, shows: compared },
    { name: "teach-task-empty", at: `#/teach/${tasks.part}`, shows: "main p" },
    { name: "teach-takes-differ", at: `#/teach/${tasks.lid}`, shows: compared },
    { name: "teach-more", at: `${task}/more`, shows: ".card .field" },
    {
      name: "teach-delete",
      at: `${task}/more`,
      shows: ".button-danger",
      then: async (page) => {
        await page.locator(".card .field").waitFor();
        await page.locator(".card").last().getByRole("button").click();
      },
    },
    {
      name: "teach-upload-refused",
      at: `${task}/more`,
      shows: ".notice[role=alert]",
      stage: { uploads: true },
      then: (page) =>
        page.locator("input[type=file]").setInputFiles({
          name: "broken.csv",
          mimeType: "text/csv",
          buffer: Buffer.from(
            recording({ spoil: (row, index) => (index === 200 ? row.with(3, "NaN") : row) }),
          ),
        }),
    },
    {
      name: "teach-soft-arm",
      at: `${task}/more`,
      shows: ".tone-soft.notice",
      stage: { live: { robot: { ...world.guidingRobot, hand: "idle" } } },
    },
    { name: "teach-record", at: `${task}/record`, shows: ".choice" },
    {
      name: "teach-count-in",
      at: `${task}/record`,
      shows: ".count",
      stage: { live: { robot: idle } },
      then: (page) => primary(page).click(),
    },
    {
      name: "teach-preparing",
      at: takeAt(world.preparingTake),
      shows: ".recording-preparing",
      stage: taking(world.preparingTake, { ...idle, state: "guiding" }),
    },
    {
      name: "teach-recording",
      at: takeAt(world.recordingTake),
      shows: ".recording-on",
      stage: taking(world.recordingTake, world.guidingRobot),
    },
    {
      name: "teach-recording-offline",
      at: takeAt(world.recordingTake),
      shows: ".recording-old",
      stage: { ...taking(world.recordingTake, world.guidingRobot), lost: true },
    },
    {
      name: "teach-paused",
      at: takeAt(world.recordingTake),
      shows: ".recording-paused",
      stage: taking(
        { ...world.recordingTake, paused_at_deg: world.guidingRobot.joints_deg },
        world.guidingRobot,
      ),
    },
    {
      name: "teach-cut",
      at: `${task}/takes/${world.take}`,
      shows: ".trim-steps",
      then: async (page) => {
        await page.locator(".card:has(.trim) summary").click();
        await top(page, ".card:has(.trim)");
      },
    },
    {
      name: "teach-review",
      at: `#/teach/${tasks.lid}/takes/${world.waitingTake}`,
      shows: ".panels canvas",
    },
    { name: "teach-take", at: `${task}/takes/${world.take}`, shows: ".panels canvas" },
    {
      name: "teach-take-numbers",
      at: `${task}/takes/${world.take}`,
      shows: ".panels tbody td",
      then: async (page) => {
        await page.locator(".panels summary").click();
        await top(page, ".panels details");
      },
    },
    {
      name: "teach-training-waits",
      at: `${task}/models/${world.model}`,
      shows: ".progress-unknown",
      stage: learning("queued"),
    },
    {
      name: "teach-training",
      at: `${task}/models/${world.model}`,
      shows: ".progress-bar:not(.progress-unknown)",
      stage: learning("running"),
    },
    { name: "teach-result", at: `${task}/models/${world.model}`, shows: ".panels canvas" },
    {
      name: "teach-result-figures",
      at: `${task}/models/${world.model}`,
      shows: "details[open] .figures",
      then: (page) => page.locator(".folded summary").click(),
    },
    { name: "run", at: "#/run", shows: ".row" },
    {
      name: "run-nothing",
      at: "#/run",
      shows: ".button-primary",
      stage: { answers: { "/tasks": [] } },
    },
    { name: "run-setup", at: `#/run/${tasks.drill}`, shows: ".choice-row" },
    { name: "run-typed", at: `#/run/${tasks.drill}`, shows: ".joint-inputs", then: typed },
    {
      name: "run-typed-wrong",
      at: `#/run/${tasks.drill}`,
      shows: ".hint-bad",
      then: async (page) => {
        await typed(page);
        await page.locator(".joint-inputs input").nth(1).fill("200");
      },
    },
    {
      name: "run-preview",
      at: `#/run/${tasks.drill}`,
      shows: ".panels canvas",
      then: (page) => primary(page).click(),
    },
    {
      name: "run-moving",
      at: motionAt + world.motion,
      shows: ".pace",
      stage: moving({ paused: false, phase: "motion", speed: 0.75 }),
    },
    {
      name: "run-paused",
      at: motionAt + world.motion,
      shows: ".pace",
      stage: moving({ paused: true, phase: "paused", speed: 0.75 }),
    },
    {
      name: "run-held",
      at: motionAt + world.motion,
      shows: ".hold",
      stage: moving({ paused: false, phase: "motion", speed: 0.25, held: true }),
    },
    {
      name: "run-held-waits",
      at: motionAt + world.motion,
      shows: ".hold",
      stage: moving({ paused: false, phase: "paused", speed: 0.25, held: false }),
    },
    { name: "run-result", at: motionAt + world.motion, shows: ".panels canvas" },
    {
      name: "run-replay",
      at: motionAt + world.motion,
      shows: ".replay table",
      then: async (page) => {
        await page.locator(".replay").waitFor();
        await page.getByRole("slider").fill("4");
        await top(page, ".replay");
      },
    },
    {
      name: "run-by-joint",
      at: motionAt + world.motion,
      shows: "details[open] tbody",
      then: async (page) => {
        await page.locator("main > .numbers summary").click();
        await top(page, "main > .numbers");
      },
    },
    {
      name: "run-events",
      at: motionAt + world.motion,
      shows: ".files .button",
      then: async (page) => {
        await page.locator(".files").waitFor();
        await top(page, ".events");
      },
    },
    {
      name: "run-outcome",
      at: motionAt + world.stopped,
      shows: ".outcome[aria-pressed=true]",
      then: (page) => top(page, ".card:has(.outcome)"),
    },
    {
      name: "run-questions",
      at: `${motionAt}${world.motion}/questions`,
      shows: ".rating",
      then: (page) => page.locator(".rating-answer").nth(3).click(),
    },
    { name: "run-positions", at: `#/run/${tasks.drill}/positions`, shows: ".rows .card" },
    { name: "run-stopped", at: motionAt + world.stopped, shows: ".panels canvas" },
    {
      name: "fault",
      at: "#/teach",
      shows: ".fault",
      stage: { live: { robot: { ...idle, state: "faulted", fault: FAULT } } },
    },
    {
      name: "offline",
      at: "#/teach",
      shows: ".tone-stale",
      stage: { live: { robot: idle }, lost: true },
    },
    {
      name: "stop-failed",
      at: "#/teach",
      shows: ".stop-failed",
      stage: { live: { robot: idle } },
      then: (page) => page.locator(".stop").click(),
    },
    {
      name: "no-robot",
      at: "#/teach",
      shows: ".row",
      stage: {
        live: { robot: { ...idle, kind: "none", state: "disconnected", joints_deg: null } },
      },
    },
    {
      name: "robots",
      at: "#/robots",
      shows: ".robot-row",
      stage: { answers: { "/robots": cell }, live: { robot: cell[0] } },
    },
    {
      name: "control-other",
      at: "#/teach",
      shows: ".control-strip",
      stage: { live: { robot: { ...idle, control: { phone: { id: "other", name: "Ana" } } } } },
    },
    {
      name: "control-asked",
      at: "#/teach",
      shows: ".control-answers",
      stage: {
        live: {
          robot: {
            ...idle,
            control: { phone: { id: OWN_PHONE, name: "" }, asked_by: { id: "other", name: "Ana" } },
          },
        },
      },
    },
    { name: "dashboard", at: "#/dashboard", shows: ".dashboard td" },
    {
      name: "dashboard-answers",
      at: "#/dashboard",
      shows: ".dashboard .radar",
      then: async (page) => {
        await page.locator(".radar").first().waitFor();
        await top(page, ".dashboard > .dashboard-part:last-child");
      },
    },
    { name: "language", at: "#/language", shows: ".language-choice" },
    {
      name: "pairing",
      at: "#/teach",
      shows: ".code",
      stage: { answers: { "/session": { pairing_required: true, paired: false, version: "" } } },
    },
    { name: "page-missing", at: "#/nowhere", shows: ".button-primary" },
  ];
}

/** Makes a phone ready for states: what it remembers, and stages. Returns what sets the stage. */
export async function readyForStates(context, language = "en") {
  const remembered = { "team.language": language, "team.phone": OWN_PHONE };
  await context.addInitScript((known) => {
    for (const [key, value] of Object.entries(known)) localStorage.setItem(key, value);
  }, remembered);
  return openStages(context);
}

/** Opens a state on a phone whose stages were opened; resolves when it is on the screen. */
export async function enter(page, setStage, state, base) {
  setStage(state.stage);
  // Another address each time: the page starts anew and keeps nothing of the state before.
  await page.goto(new URL(`/?${state.name}`, base).href + state.at);
  await page.locator("main h1").waitFor();
  if (state.then) await state.then(page);
  await page.locator(state.shows).first().waitFor();
  await page.locator(".loading").waitFor({ state: "detached" });
}
