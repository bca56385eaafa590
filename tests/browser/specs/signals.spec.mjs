// The gripper on the phone: worked by a big button while the arm is led, marked on the take, and
// listed before and after a motion that works it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser } from "../support/phone.mjs";
import {
  button,
  keepTake,
  motionDone,
  newTask,
  preview,
  robotReady,
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

test("the gripper is worked while recording, and the motion works it again", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await robotReady(page);
  await newTask(page, "Hold it");
  await startRecording(page, { script: "Around an obstacle" });
  await page.getByText("Gripper is now at “open”.").waitFor();
  await button(page, "Gripper: close").click();
  await button(page, "Gripper: open").waitFor();
  await inspect(page, "teach-gripper");

  const worked = page.getByRole("listitem").filter({ hasText: "Gripper: close" });
  await worked.waitFor();
  assert.match(await worked.innerText(), /at \d+\.\d s/);
  await keepTake(page);

  await train(page);
  await runSetup(page);
  await page.getByRole("radio", { name: /^Full/ }).check();
  await preview(page);
  // The gripper still holds what the hand gave it: the page says what will happen to it.
  await page.getByText("it will open first, as you showed it").waitFor();
  await page.getByRole("heading", { name: "Worked on the way" }).waitFor();
  await inspect(page, "run-preview-gripper");
  await startMotion(page);
  await motionDone(page);
  await page.getByRole("heading", { name: "Worked by the motion" }).waitFor();
  assert.equal(await page.getByRole("listitem").filter({ hasText: "Gripper:" }).count(), 2);
  await inspect(page, "run-result-gripper");
  await hangUp(phone);
});
