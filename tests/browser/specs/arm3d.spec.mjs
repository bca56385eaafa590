// The picture of the arm: that it shows the pose it should, can be turned without a swipe, and that
// the virtual arm follows a finger and buttons.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { canvas, pictureShown, shownPose, toolOnScreen } from "../support/arm-picture.mjs";
import { taskFromFiles } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser, until, withoutWebGl } from "../support/phone.mjs";
import {
  button,
  heading,
  newTask,
  preview,
  robotReady,
  runSetup,
  train,
} from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Waits until the pixels of the picture are others than before. */
async function repainted(page, before) {
  await until(page, "the picture is another", async () => {
    return !before.equals(await canvas(page).screenshot());
  });
}

/** From the task's page into a recording that the person leads. */
async function leadMyself(page) {
  await page.getByRole("link", { name: /^(Record a|Another) take$/ }).click();
  await heading(page, "Record a take").waitFor();
  await page.getByRole("radio", { name: /^I lead it myself/ }).check();
  await robotReady(page);
  await inspect(page, "teach-record-myself");
  await button(page, "Record").click();
  await page.getByRole("timer").waitFor();
  await pictureShown(page);
}

test("the planned motion is a picture that a slider and buttons move", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  const task = await taskFromFiles("As a picture");
  await openApp(page, `#/teach/${task.id}`);
  await train(page);
  await runSetup(page);
  await preview(page);
  await pictureShown(page);
  await canvas(page).scrollIntoViewIfNeeded();

  const atStart = await shownPose(page);
  const before = await canvas(page).screenshot();
  const slider = page.getByRole("slider", { name: "Time in the motion" });
  await slider.fill(String(Number(await slider.getAttribute("max")) / 2));
  await until(page, "the arm has moved", async () => {
    const now = await shownPose(page);
    return now.some((angle, joint) => Math.abs(angle - atStart[joint]) > 1);
  });
  await repainted(page, before);
  await page.getByRole("img", { name: /^The arm on its planned way.*cm up/ }).waitFor();

  await button(page, "Play").click();
  await button(page, "Pause").click();
  await page.getByText("Turn the picture").click();
  for (const name of ["Top", "Front", "Side", "Turn left", "Turn right", "Closer", "Farther"]) {
    const pose = await shownPose(page);
    const picture = await canvas(page).screenshot();
    await button(page, name).click();
    await repainted(page, picture);
    assert.deepEqual(await shownPose(page), pose, "only the view turns");
  }
  await inspect(page, "run-preview-picture");
  await hangUp(phone);
});

test("without WebGL the pages say so and go on", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await withoutWebGl(page);
  const task = await taskFromFiles("Without a picture");
  await openApp(page, `#/teach/${task.id}`);
  await page.getByRole("link", { name: /^Take 1, / }).click();
  await page.getByText("This phone cannot show the arm as a picture").waitFor();
  await page.getByRole("img", { name: /^Recorded joint angles/ }).waitFor();
  await page.getByRole("slider", { name: "Time in the motion" }).fill("2");
  await hangUp(phone);
});

test("the virtual arm follows a finger and buttons, and the take shows the way", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "Led by a finger");
  await leadMyself(page);
  const finger = await phone.context.newCDPSession(page);
  const touch = (type, ...touchPoints) =>
    finger.send("Input.dispatchTouchEvent", { type, touchPoints });
  await page.getByText("Put a finger on the ball").waitFor();
  await inspect(page, "teach-lead-myself");

  const from = await toolOnScreen(page);
  const pose = await shownPose(page);
  await touch("touchStart", from);
  for (let step = 1; step <= 12; step += 1) {
    await touch("touchMove", { x: from.x - 4 * step, y: from.y + 4 * step });
  }
  await until(page, "the tool is under the finger", async () => {
    const now = await toolOnScreen(page);
    return Math.hypot(now.x - (from.x - 48), now.y - (from.y + 48)) < 12;
  });
  await touch("touchEnd");
  assert.notDeepEqual(await shownPose(page), pose);
  await page.getByText("Put a finger on the ball").waitFor({ state: "detached" });

  await page.getByText("Move with buttons").click();
  for (const name of ["Up", "Twist left"]) {
    const before = await shownPose(page);
    const pressed = button(page, name);
    await pressed.focus();
    await page.keyboard.down("Enter");
    await until(page, `the arm follows ${name}`, async () => {
      const now = await shownPose(page);
      return now.some((angle, joint) => Math.abs(angle - before[joint]) > 3);
    });
    await page.keyboard.up("Enter");
  }
  await inspect(page, "teach-lead-buttons");
  await button(page, "Stop recording").click();
  await button(page, "Keep").waitFor();
  await pictureShown(page);
  await inspect(page, "teach-review-picture");
  await button(page, "Keep").click();
  await page.getByRole("link", { name: "Take 1, Kept" }).waitFor();
  await hangUp(phone);
});
