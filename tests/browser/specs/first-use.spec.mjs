// Somebody who has never seen the app: from the first page to the goal reached, counting every
// press. Only the task's name is typed; the arm is led by a finger in its picture.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { pictureShown, toolOnScreen } from "../support/arm-picture.mjs";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import { button, heading, linkNamed, robotReady } from "../support/steps.mjs";

const MOST_TAPS = 12;
const LONG_MS = 300_000;

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Presses that count. A button that is held counts as one. */
function counted(page) {
  const taps = [];
  return {
    taps,
    async tap(target) {
      taps.push(await target.textContent());
      await target.click();
    },
    async holdUntil(target, done) {
      await target.hover();
      await page.mouse.down();
      taps.push("held");
      await done();
      await page.mouse.up();
    },
  };
}

/** Leads the arm out, down and back to where it was, which is how a worker shows a motion that the
 *  next take begins where this one did. */
async function leadThere(page) {
  const from = await toolOnScreen(page);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (const [x, y] of [
    [-50, 0],
    [-50, 40],
    [-50, 0],
    [0, 0],
  ]) {
    const to = { x: from.x + x, y: from.y + y };
    await page.mouse.move(to.x, to.y, { steps: 8 });
    await until(page, "the tool is under the finger", async () => {
      const now = await toolOnScreen(page);
      return Math.hypot(now.x - to.x, now.y - to.y) < 6;
    });
  }
  await page.mouse.up();
}

test("twelve presses lead from the first page to a motion that the arm has made", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await robotReady(page);
  const { taps, tap, holdUntil } = counted(page);

  await tap(linkNamed(page, "New task"));
  await page.getByLabel("Name of the task").fill("Load the drilling machine");
  await inspect(page, "first-use-name");
  await tap(button(page, "Create task"));
  await robotReady(page);
  await tap(button(page, "Record"));
  for (let take = 1; take <= 3; take += 1) {
    await page.getByRole("timer").waitFor();
    await pictureShown(page);
    await inspect(page, "first-use-recording");
    await leadThere(page);
    await tap(button(page, "Stop recording"));
    const another = button(page, "Keep, one more");
    await another.waitFor();
    await heading(page, `Take ${take}`).waitFor();
    await page.getByRole("img", { name: /^Recorded joint angles/ }).waitFor();
    await inspect(page, `first-use-review-${take}`);
    // One take alone is not put forward to be trained.
    assert.equal(await button(page, "Keep and train").count(), take === 1 ? 0 : 1);
    if (take < 3) await tap(another);
  }
  await tap(button(page, "Keep and train"));
  const run = button(page, "Run it");
  await run.waitFor({ timeout: LONG_MS });
  await page.getByRole("img", { name: /^Learned motion/ }).waitFor();
  await inspect(page, "first-use-result");
  await tap(run);
  await heading(page, "Planned motion").waitFor();
  await robotReady(page);

  await tap(button(page, "Get ready"));
  const hold = button(page, "Hold to move");
  await hold.waitFor();
  await holdUntil(hold, () => heading(page, "Goal reached").waitFor({ timeout: LONG_MS }));
  console.log(`# ${taps.length} presses: ${taps.join(" | ")}`);
  assert.ok(taps.length <= MOST_TAPS, `${taps.length} presses: ${taps.join(" | ")}`);
  await hangUp(phone);
});
