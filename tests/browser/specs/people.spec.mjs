// What a worker says after a run: whether it worked, and the questionnaire once a shift; and what
// the overview makes of it for operators.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { trainedTask } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser, picture } from "../support/phone.mjs";
import { button, heading, linkNamed, motionDone, preview, startMotion } from "../support/steps.mjs";

// The server may have seen this spec before.
const NAME = `Hang up the door ${Date.now() % 10_000}`;
const STATEMENTS = [
  "The arm has learned the right motion.",
  "Working with the arm felt safe to me.",
  "The arm arrived exactly at the goal.",
  "It was easy to teach the arm a motion.",
  "It was fun to teach the arm a motion.",
];

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const invitation = (page) => page.getByRole("region", { name: "Five short questions" });

/** Opens the page anew and gives the server's answer to whether the questionnaire is due. */
async function dueAfterReload(page) {
  await page.reload({ waitUntil: "commit" });
  const answer = await page.waitForResponse((one) => one.url().includes("/questionnaire/due"));
  return (await answer.json()).due;
}

test("after a run a worker says how it went, is asked once, and the overview shows it", async () => {
  const task = await trainedTask(NAME);
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page, `#/run/${task.id}`);
  await page.getByRole("radio", { name: /^Full/ }).check();
  await preview(page);
  await startMotion(page);
  await motionDone(page);
  await invitation(page).waitFor();
  const motion = new URL(page.url()).hash;

  const [yes, no] = ["It worked", "It did not"].map((name) => button(page, name));
  assert.equal(await yes.getAttribute("aria-pressed"), "false");
  await yes.click();
  await page.getByText("Written down. You may change it.").waitFor();
  assert.equal(await yes.getAttribute("aria-pressed"), "true");
  await inspect(page, "run-outcome-worked");
  await no.click();
  const note = page.getByLabel(/^What went wrong/);
  await note.fill("The part slipped.");
  await button(page, "Save the note").click();
  await page.getByText("The note is saved.").waitFor();
  assert.equal(await no.getAttribute("aria-pressed"), "true");
  await inspect(page, "run-outcome-not");

  await answer(page, motion);
  await secondPerson(motion);
  await lastRuns(page, task);
  await overview(page);
  await hangUp(phone);
});

async function answer(page, motion) {
  await invitation(page).scrollIntoViewIfNeeded();
  await inspect(page, "run-invitation");
  await invitation(page).getByRole("link", { name: "Answer", exact: true }).click();
  await heading(page, "Five short questions").waitFor();
  await page.getByText("Still open: 5").waitFor();
  assert.ok(await button(page, "Send").isDisabled());
  const group = (statement) => page.getByRole("radiogroup", { name: statement });
  // By keyboard, as a screen reader's user would: the arrow keys go along the row.
  await group(STATEMENTS[0]).getByRole("radio", { name: "5, completely" }).press("Space");
  await group(STATEMENTS[1]).getByRole("radio", { name: "3, undecided" }).press("Space");
  await page.keyboard.press("ArrowRight");
  assert.ok(await group(STATEMENTS[1]).getByRole("radio", { name: "4, mostly" }).isChecked());
  await inspect(page, "run-questions");
  for (const [index, name] of ["4, mostly", "5, completely", "2, rather not"].entries()) {
    await group(STATEMENTS[index + 2])
      .getByRole("radio", { name })
      .check();
  }
  await button(page, "Send").click();
  await heading(page, "Goal reached").waitFor();
  assert.equal(new URL(page.url()).hash, motion);
  assert.equal(await invitation(page).count(), 0);
  assert.equal(await dueAfterReload(page), false);
  await page.getByRole("img", { name: /^Planned and measured/ }).waitFor();
  assert.equal(await invitation(page).count(), 0, "not asked again in this shift");
}

/** Another phone is another person, who does not want to answer. */
async function secondPerson(motion) {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page, motion);
  await button(invitation(page), "Not this shift").click();
  await invitation(page).waitFor({ state: "detached" });
  assert.equal(await dueAfterReload(page), false);
  await hangUp(phone);
}

/** What happened last time stands on the page with the choices. */
async function lastRuns(page, task) {
  await openApp(page, `#/run/${task.id}`);
  const run = page.getByRole("link", { name: /Goal reached Did not work$/ });
  await run.waitFor();
  await run.scrollIntoViewIfNeeded();
  await inspect(page, "run-setup-recent");
}

async function overview(page) {
  await openApp(page, "#/run");
  await linkNamed(page, "Overview of the cell").click();
  await heading(page, "Overview").waitFor();
  const runs = page.getByRole("table", { name: "Latest runs" });
  const row = runs.getByRole("row").filter({ hasText: NAME }).first();
  for (const text of ["Goal reached", "Did not"]) await row.getByText(text).waitFor();
  const counts = page.getByRole("table", { name: "Tasks" }).getByRole("row");
  await counts.filter({ hasText: NAME }).getByText("0 % (0 of 1)").waitFor();
  await inspect(page, "dashboard");
  const radar = (title) =>
    page.getByRole("img", {
      name: `${title}. Best: Right motion (5.0). Weakest: Fun (2.0). Answers: 1.`,
    });
  await radar(NAME).waitFor();
  await radar(NAME).scrollIntoViewIfNeeded();
  await inspect(page, "dashboard-radar");
  await page.getByRole("radio", { name: "By month" }).check();
  await page.getByLabel("Of which task?").selectOption({ label: NAME });
  const months = { month: "long", year: "numeric", timeZone: "UTC" };
  await radar(new Intl.DateTimeFormat("en", months).format(new Date())).waitFor();
  await inspect(page, "dashboard-months");
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.emulateMedia({ colorScheme: "light" });
  await heading(page, "Overview").scrollIntoViewIfNeeded();
  await picture(page, "dashboard-wide");

  // What is not heard of any more is said to be old, and fresh again as soon as it is.
  await page.route("**/api/v1/dashboard", (route) => route.abort());
  await page.getByText(/^Old: last heard/).waitFor();
  await page.unroute("**/api/v1/dashboard");
  await page.getByText("Just updated").waitFor();
}
