// A phone that is locked, loses its page or its network finds everything where it is.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { keepTrainerBusy, taskFromFiles } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import {
  button,
  heading,
  keepTake,
  linkNamed,
  newTask,
  robotReady,
  startRecording,
} from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test("a reload in the middle of a recording comes back to the recording", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "Reloaded while recording");
  await startRecording(page);
  await page.reload();
  await page.getByRole("timer").waitFor();
  await button(page, "Stop recording").click();
  await keepTake(page);
  await page.getByRole("link", { name: "Take 1, Kept" }).waitFor();
  await hangUp(phone);
});

test("a reload in the middle of a training comes back to the training, which can be cancelled", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  const task = await taskFromFiles("Reloaded while training");
  const enough = await keepTrainerBusy(8);
  await openApp(page, `#/teach/${task.id}`);
  await button(page, "Train").click();
  await page.getByRole("progressbar", { name: "Training" }).waitFor();
  await page.reload();
  await page.getByRole("progressbar", { name: "Training" }).waitFor();
  await inspect(page, "teach-training-waits");
  await button(page, "Cancel training").click();
  await page.getByText("The training was cancelled").waitFor();
  await enough();
  await linkNamed(page, "Back to the takes").click();
  for (const take of [1, 2, 3]) {
    await page.getByRole("link", { name: `Take ${take}, Kept` }).waitFor();
  }
  await hangUp(phone);
});

test("without network the robot's state is shown as old, and comes back by itself", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  let cut = false;
  const open = new Set();
  await page.routeWebSocket(/\/api\/v1\/live\?/, (socket) => {
    if (cut) return socket.close();
    socket.connectToServer();
    open.add(socket);
    return undefined;
  });
  await openApp(page);
  await robotReady(page);
  cut = true;
  await Promise.all([...open].map((socket) => socket.close()));
  const bar = page.getByRole("region", { name: "Robot" });
  await bar.getByText(/Offline/).waitFor();
  await until(page, "the age is shown", async () => / ago$/.test(await bar.innerText()));
  await inspect(page, "offline");
  cut = false;
  await robotReady(page);
  assert.ok(await heading(page, "Teach").isVisible());
  await hangUp(phone);
});
