// The whole way on a phone: name a task, show it three times, train, look at the result, preview,
// run, and read what the arm really did.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import {
  button,
  figure,
  figureNumber,
  heading,
  linkNamed,
  motionDone,
  newTask,
  preview,
  recordTake,
  robotReady,
  runSetup,
  startMotion,
  train,
} from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test("a motion is taught by three takes and the arm does it", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await robotReady(page);
  await inspect(page, "teach-start");
  await newTask(page, "Load the drilling machine");
  await inspect(page, "teach-task-empty");

  for (let take = 1; take <= 3; take += 1) {
    await recordTake(page, { script: "Pick and place" });
    await page.getByRole("link", { name: `Take ${take}, Kept` }).waitFor();
    if (take === 1) {
      // One take may be trained, and the page says what is lost.
      await page.getByText("from one alone nobody can tell what matters").waitFor();
      assert.ok(await button(page, "Train").isEnabled());
    }
  }
  await page.getByText("3 takes kept").waitFor();
  // Whatever it is that these takes are: there is advice, and all three were compared.
  await page
    .getByRole("status")
    .getByText(/that's enough|ecord one more/)
    .waitFor();
  await inspect(page, "teach-task");

  await train(page);
  await page.getByRole("img", { name: /^Learned motion/ }).waitFor();
  await inspect(page, "teach-result");
  await page.getByText("All figures").click();
  for (const name of ["Gaussians (k)", "Spring (alpha_z)", "Basis functions (N)", "Objective"]) {
    assert.ok((await figureNumber(page, name)) > 0, name);
  }
  assert.equal(await figure(page, "Takes used"), "3");
  await inspect(page, "teach-result-figures");

  await runSetup(page);
  await inspect(page, "run-setup");
  await page.getByRole("radio", { name: /^Full/ }).check();
  await preview(page);
  await inspect(page, "run-preview");
  await startMotion(page);
  await page.getByRole("progressbar", { name: "Progress of the motion" }).waitFor();
  await page.getByText("Doing the motion").waitFor();
  await inspect(page, "run-moving");

  await motionDone(page);
  await inspect(page, "run-result");
  assert.ok((await figureNumber(page, "End error in the joints (e_j)")) <= 0.3);
  assert.ok((await figureNumber(page, "Likeness of the path (GMCC)")) >= 0.95);
  await replayAndTakeAway(page);

  await button(page, "Run again").click();
  await heading(page, "Planned motion").waitFor();
  await runToTypedGoal(page);
  await linkNamed(page, "Run").click();
  await page.getByRole("link", { name: "Run Load the drilling machine" }).last().waitFor();
  await inspect(page, "run-start");
  await hangUp(phone);
});

/** The record of the motion: played back, told in events, and saved as files. */
async function replayAndTakeAway(page) {
  const slider = page.getByRole("slider", { name: "Time in the motion" });
  const at = () => slider.evaluate((input) => input.valueAsNumber);
  await button(page, "Play").click();
  await until(page, "the replay goes on", async () => (await at()) > 0.5);
  await button(page, "Pause").click();
  await slider.press("End");
  const table = page.getByRole("table", { name: "Joint angles at this time" });
  assert.equal(await table.getByRole("row").count(), 7);
  await page.getByText("Coming to rest", { exact: true }).waitFor();
  await inspect(page, "run-replay");
  await page.getByText("The arm stands at the end of the plan.").waitFor();
  await page.getByText("Off the plan, joint by joint").click();
  await inspect(page, "run-by-joint");
  await linkNamed(page, "Table (CSV)").scrollIntoViewIfNeeded();
  await inspect(page, "run-files");
  for (const [name, ending] of [
    ["Table (CSV)", /^motion_\w+\.csv$/],
    ["Recording (MCAP)", /^motion_\w+\.mcap$/],
  ]) {
    const saved = page.waitForEvent("download");
    await linkNamed(page, name).click();
    const file = await saved;
    assert.match(file.suggestedFilename(), ending);
    assert.equal(await file.failure(), null);
  }
}

/** Another goal, typed with a decimal comma: a slip is caught at once, and the arm gets there. */
async function runToTypedGoal(page) {
  await linkNamed(page, "Change").click();
  await page.getByRole("radio", { name: /^Joint angles I type/ }).check();
  const joint = (number) => page.getByLabel(`Joint ${number} in degrees`);
  const taught = Number(await joint(1).inputValue());
  await joint(2).fill("200");
  await page.getByText("Must be from −180° to 180°").waitFor();
  await page.getByText("Correct the joint angles first.").waitFor();
  assert.ok(await button(page, "Preview").isDisabled());
  await inspect(page, "run-typed-wrong");
  await joint(2).fill("10,5");
  await joint(1).fill((taught + 3).toFixed(1).replace(".", ","));
  await inspect(page, "run-typed");
  await preview(page);
  await startMotion(page);
  await motionDone(page);
  assert.ok((await figureNumber(page, "End error in the joints (e_j)")) <= 0.3);
}
