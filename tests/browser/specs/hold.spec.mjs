// Hold-to-run: the arm moves while a finger is on the button, and two phones at one robot.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { taskFromFiles } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { BASE_URL, hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import {
  button,
  getReady,
  heading,
  hold,
  linkNamed,
  motionDone,
  preview,
  robotReady,
  train,
} from "../support/steps.mjs";

/** Time in which the arm must stand after the network is cut, ms. */
const STANDS_MS = 500;

let browser;
let task;
before(async () => {
  browser = await openBrowser();
  task = await taskFromFiles("Held by a finger");
  const phone = await newPhone(browser);
  await openApp(phone.page, `#/teach/${task.id}`);
  await train(phone.page);
  await hangUp(phone);
});
after(() => browser.close());

const get = async (path) => (await fetch(new URL(`/api/v1${path}`, BASE_URL))).json();
const run = async () => (await get("/robots/virtual")).run;

/** Time within the plan, once it does not change any more. */
async function standing(page) {
  let [before, now] = [NaN, (await run()).t_s];
  await until(page, "the arm stands", async () => {
    [before, now] = [now, (await run()).t_s];
    return before === now;
  });
  return now;
}

async function planned(page) {
  await openApp(page, `#/run/${task.id}`);
  await page.getByRole("radio", { name: /^Full/ }).check();
  await preview(page);
}

test("the arm moves while the button is held, waits when it is let go, and goes on", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await planned(page);
  await inspect(page, "run-preview-hold");
  await getReady(page);
  await inspect(page, "run-hold-waits");
  const begin = await standing(page);
  await hold(page);
  await until(page, "the arm moves", async () => (await run()).t_s > begin + 0.5);
  await inspect(page, "run-hold-moves");
  await page.mouse.up();
  await heading(page, "The arm waits for you").waitFor();
  const stood = await standing(page);
  assert.ok(stood > begin + 0.5);
  await button(page, "Hold to move").focus();
  await page.keyboard.down(" ");
  await heading(page, "The arm is moving").waitFor();
  await until(page, "the arm goes on", async () => (await run()).t_s > stood + 0.3);
  await page.keyboard.up(" ");
  await heading(page, "The arm waits for you").waitFor();
  // Another window, a call, a locked screen.
  await hold(page);
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await heading(page, "The arm waits for you").waitFor();
  await page.mouse.up();
  await hold(page);
  await motionDone(page);
  await page.mouse.up();
  await hangUp(phone);
});

test("with the network cut while the button is held, the arm stands within half a second", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  let cut = false;
  await page.routeWebSocket(/\/api\/v1\/live\?/, (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((message) => cut || server.send(message));
    server.onMessage((message) => cut || socket.send(message));
  });
  await planned(page);
  await getReady(page);
  const id = new URL(page.url()).hash.split("/").at(-1);
  const begin = await standing(page);
  await hold(page);
  await until(page, "the arm moves", async () => (await run()).t_s > begin + 1);
  cut = true;
  const cutAtMs = Date.now();
  await until(page, "nobody holds it", async () => (await run()).held === false);
  await standing(page);
  // The phone notices too, and does not begin again by itself.
  await page
    .getByRole("region", { name: "Robot" })
    .getByText(/Offline/)
    .waitFor();
  await page.mouse.up();
  await fetch(new URL("/api/v1/robots/virtual/stop", BASE_URL), { method: "POST" });
  let motion;
  await until(page, "the motion is over", async () => {
    motion = await get(`/reproductions/${id}`);
    return motion.state === "stopped";
  });
  const flight = await get(`/reproductions/${id}/flight?points=2000`);
  const armedMs = Date.parse(motion.armed_at);
  const last = flight.plan_t_s.at(-1);
  const at = flight.plan_t_s.findIndex((t) => last - t < 1e-3);
  const stoodMs = armedMs + 1000 * flight.t_s[at] - cutAtMs;
  console.log(`# the arm stood ${stoodMs.toFixed(0)} ms after the cut`);
  assert.ok(stoodMs <= STANDS_MS, `it stood after ${stoodMs} ms`);
  await hangUp(phone);
});

test("of two phones at one robot one has control; the other sees who, can ask, and gets it", async () => {
  const [anna, ben] = [await newPhone(browser), await newPhone(browser)];
  for (const [{ page }, name] of [
    [anna, "Anna"],
    [ben, "Ben"],
  ]) {
    await openApp(page, "#/language");
    await page.getByLabel("Name of this phone").fill(name);
    await inspect(page, "language-and-name");
    await button(page, "Save").click();
    await openApp(page, `#/teach/${task.id}/more`);
    await page.reload();
    await robotReady(page);
  }
  await button(anna.page, "Make the arm soft").click();
  await button(anna.page, "Make the arm stiff").waitFor();
  const control = (page) => page.getByRole("region", { name: "Control of the robot" });
  await control(ben.page).getByText("Anna controls this robot.").waitFor();
  assert.ok(await button(ben.page, "Make the arm stiff").isDisabled());
  await inspect(ben.page, "control-other");
  await button(ben.page, "Ask for control").click();
  await control(ben.page).getByText("Wait for the answer").waitFor();
  await control(anna.page).getByText("Ben asks for control").waitFor();
  await inspect(anna.page, "control-asked");
  await button(anna.page, "Give").click();
  await control(anna.page).getByText("Ben controls this robot.").waitFor();
  await button(ben.page, "Make the arm stiff").click();
  await robotReady(ben.page);
  // Stop is for both.
  await button(anna.page, "Stop").click();
  await anna.page.getByText("Stop was sent").waitFor();
  await Promise.all([hangUp(anna), hangUp(ben)]);
});
