// What the phone says about the takes before anything is trained.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { recording } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openBrowser } from "../support/phone.mjs";
import { button, linkNamed, newTask } from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Uploads a take and opens it, where it waits for a decision. */
async function addTake(page, number, options) {
  await linkNamed(page, "More").click();
  await page.getByLabel("Upload a recorded file").setInputFiles({
    name: "swing.csv",
    mimeType: "text/csv",
    buffer: Buffer.from(recording(options)),
  });
  await page.getByText(`The file is now take ${number}`).waitFor();
  await page.getByRole("link", { name: "Back" }).click();
  await page.getByRole("link", { name: `Take ${number}, Keep it?` }).click();
  await button(page, "Keep").waitFor();
}

const advice = (page, words) => page.getByRole("status").getByText(words).waitFor();

test("after each take the phone says whether to record another, and which one differs", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "Swing aside");
  const steps = [
    [0.96, /^Record one more take, and then a third/],
    [1, /^Record one more take\.$/],
    [1.05, /that's enough/],
  ];
  for (const [index, [size, words]] of steps.entries()) {
    await addTake(page, index + 1, { size });
    await advice(page, words);
    await button(page, "Keep").click();
    await page.getByRole("heading", { name: "Takes" }).waitFor();
    await advice(page, words);
  }
  await page.getByRole("link", { name: "Take 3, Kept, Agrees" }).waitFor();
  await inspect(page, "teach-takes-agree");

  // Joint 5 goes its own way in the middle.
  const spoil = (row) => row.with(5, -45 + 16 * Math.sin((Math.PI * row[0]) / 4));
  await addTake(page, 4, { spoil });
  await advice(page, /^Take 4 differs from the others, most around the middle at joint 5/);
  await inspect(page, "teach-review-differs");
  await button(page, "Keep").click();
  await page.getByRole("heading", { name: "Takes" }).waitFor();
  const odd = "Take 4, Kept, Differs most around the middle at joint 5";
  await page.getByRole("link", { name: odd }).waitFor();
  await inspect(page, "teach-takes-differ");
  assert.ok(await button(page, "Train").isEnabled(), "it is advice, not a lock");

  await page.getByRole("link", { name: odd }).click();
  await button(page, "Discard").click();
  await advice(page, /that's enough/);
  await hangUp(phone);
});

test("takes of different motions are named before a training would refuse them", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "Swing or lift");
  const lift = (row) => [row[0], 0, 8 + 50 * Math.sin((Math.PI * row[0]) / 4), 24, 0, -45, 0];
  for (const [index, options] of [{}, {}, { spoil: lift }].entries()) {
    await addTake(page, index + 1, options);
    await button(page, "Keep").click();
    await page.getByRole("heading", { name: "Takes" }).waitFor();
  }
  await advice(page, /^Take 3 shows another motion than take 1 and take 2\./);
  await page.getByRole("link", { name: "Take 3, Kept, Shows another motion" }).waitFor();
  await inspect(page, "teach-takes-other-motion");
  await hangUp(phone);
});
