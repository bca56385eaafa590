// Stop, from the screen of a motion and without the live connection.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { taskFromFiles } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser } from "../support/phone.mjs";
import {
  button,
  heading,
  keepTake,
  newTask,
  preview,
  runSetup,
  startMotion,
  startRecording,
  train,
} from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test("a motion is paused, goes on, is stopped, and can be led back or started again by a person", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  const task = await taskFromFiles("To be stopped");
  await openApp(page, `#/teach/${task.id}`);
  await train(page);
  await runSetup(page);
  await preview(page);
  await startMotion(page);
  // From where it has not moved there is no way back.
  await page.getByRole("status").getByText("Doing the motion").waitFor();
  await button(page, "Pause").click();
  await page.getByRole("status").getByText("Paused").waitFor();
  await heading(page, "The arm waits on its way").waitFor();
  await inspect(page, "run-paused");
  await button(page, "Go on").click();
  await button(page, "Slower").click();
  await page.getByText("Speed 75").waitFor();
  await button(page, "Stop").click();
  await heading(page, "Stopped").waitFor();
  await page.getByText("The arm was stopped before the goal.").waitFor();
  await inspect(page, "run-stopped");
  await button(page, "Back to the start").click();
  await heading(page, "Planned motion").waitFor();
  assert.ok(await button(page, "Start").isVisible());
  await page.goBack();
  await button(page, "Run again").click();
  await heading(page, "Planned motion").waitFor();
  assert.ok(await button(page, "Start").isVisible());
  await hangUp(phone);
});

test("Stop reaches the server when the live connection is down", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await page.routeWebSocket(/\/api\/v1\/live\?/, (socket) => socket.close());
  await openApp(page);
  const request = page.waitForRequest((one) => one.url().endsWith("/api/v1/robots/virtual/stop"));
  await button(page, "Stop").click();
  assert.equal((await (await request).response()).status(), 204);
  await page.getByText("Stop was sent").waitFor();
  await hangUp(phone);
});

test("without a server Stop says that it did not get through", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await heading(page, "Teach").waitFor();
  await phone.context.setOffline(true);
  await button(page, "Stop").click();
  await page.getByText("Use the emergency stop of the robot").waitFor();
  await inspect(page, "stop-failed");
  await hangUp(phone);
});

test("Stop during a recording ends it and keeps what was recorded", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "Stopped while recording");
  await startRecording(page);
  await button(page, "Stop").click();
  await keepTake(page);
  await page.getByRole("link", { name: "Take 1, Kept" }).waitFor();
  await hangUp(phone);
});
