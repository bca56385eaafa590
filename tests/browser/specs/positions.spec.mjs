// Saved positions: one tap saves where the arm is, the motion ends there by name, and a position
// that somebody else deleted is refused in words.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { get, trainedTask } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { BASE_URL, hangUp, newPhone, openApp, openBrowser } from "../support/phone.mjs";
import { button, heading, linkNamed, preview, robotReady } from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test("a position is saved with one tap, named, used as the goal, moved and deleted", async () => {
  const task = await trainedTask("To a saved position");
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page, `#/run/${task.id}`);
  const goal = page.getByRole("group", { name: "Where shall it end?" });
  await goal.getByRole("radio", { name: /^A saved position/ }).check();
  await page.getByText("Choose a saved position first.").waitFor();
  assert.ok(await button(page, "Preview").isDisabled());
  await inspect(page, "run-setup-saved-none");

  await linkNamed(page, "Saved positions").click();
  await heading(page, "Saved positions").waitFor();
  await robotReady(page);
  await button(page, "Save where the arm is now").click();
  await page
    .getByRole("status")
    .getByText(/^Saved as Position \d+/)
    .waitFor();
  const name = page.getByLabel("Name of the position");
  await name.fill("");
  await page.getByText("Type a name first.").waitFor();
  const fixture = `Fixture ${task.id.slice(-6)}`;
  await name.fill(fixture);
  await button(page, "Rename").click();
  const entry = page.getByRole("region", { name: fixture });
  await entry.getByText(fixture, { exact: true }).waitFor();
  await inspect(page, "run-positions");
  await button(entry, "Move it to where the arm is now").click();
  await button(entry, "Yes, move it").click();
  await button(entry, "Move it to where the arm is now").waitFor();

  await linkNamed(page, "Back").click();
  await page.getByRole("radio", { name: new RegExp(`^${fixture}`) }).check();
  await inspect(page, "run-setup-saved");
  await preview(page);
  const [saved] = (await get("/positions")).filter((one) => one.name === fixture);
  await linkNamed(page, "Change").click();
  await page.getByRole("radio", { name: new RegExp(`^${fixture}`) }).waitFor();

  // Somebody else deletes it meanwhile.
  const gone = await fetch(new URL(`/api/v1/positions/${saved.id}`, BASE_URL), {
    method: "DELETE",
  });
  assert.equal(gone.status, 204);
  await button(page, "Preview").click();
  await page.getByRole("alert").getByText(`The saved position "${fixture}" was deleted.`).waitFor();
  await inspect(page, "run-setup-saved-deleted");
  await hangUp(phone);
});

test("a position is deleted only after a question", async () => {
  const task = await trainedTask("Without a position");
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page, `#/run/${task.id}/positions`);
  await robotReady(page);
  await button(page, "Save where the arm is now").click();
  const name = page.getByLabel("Name of the position");
  const shown = await name.inputValue();
  const entry = page.getByRole("region", { name: shown });
  await button(entry, "Delete this position").click();
  await button(entry, "No, keep it").click();
  await button(entry, "Delete this position").click();
  await inspect(page, "run-positions-delete");
  await button(entry, "Yes, delete").click();
  await entry.waitFor({ state: "detached" });
  await hangUp(phone);
});
