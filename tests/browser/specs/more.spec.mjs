// The rarer things of a task: files, moving the arm by hand, renaming, deleting.
import { after, before, test } from "node:test";
import { recording } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openBrowser } from "../support/phone.mjs";
import { button, heading, linkNamed, newTask, robotReady } from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const csv = (name, options) => ({
  name,
  mimeType: "text/csv",
  buffer: Buffer.from(recording(options)),
});

test("a recorded file becomes a take; a broken one is refused with what and where", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "From files");
  await linkNamed(page, "More").click();
  await heading(page, "More for this task").waitFor();
  await inspect(page, "teach-more");
  const file = page.getByLabel("Upload a recorded file");
  await file.setInputFiles(
    csv("broken.csv", { spoil: (row, index) => (index === 200 ? row.with(3, "NaN") : row) }),
  );
  await page
    .getByRole("alert")
    .getByText(/row 20\d/)
    .first()
    .waitFor();
  await inspect(page, "teach-upload-refused");
  await file.setInputFiles(csv("swing.csv"));
  await page.getByText("The file is now take 1").waitFor();
  await page.getByRole("link", { name: "Back" }).click();
  await page.getByRole("link", { name: /^Take 1, / }).click();
  await page.getByText("from a file").waitFor();
  await page.getByRole("img", { name: /^Recorded joint angles: 4.0 s/ }).waitFor();
  await page.getByText("As numbers").first().click();
  await page.getByRole("rowheader", { name: "Joint 6" }).waitFor();
  await inspect(page, "teach-take");
  await hangUp(phone);
});

test("the arm is made soft, brought back by the hand, and made stiff again", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  // As on a phone on which the virtual hand was chosen to lead, and not the person.
  await page.addInitScript(() => localStorage.setItem("team.hand-script", "f1"));
  await newTask(page, "By hand");
  await linkNamed(page, "More").click();
  await robotReady(page);
  await button(page, "Make the arm soft").click();
  await page.getByText("The arm is soft now").waitFor();
  await inspect(page, "teach-soft");
  await button(page, "Virtual hand: bring it to the start").click();
  await button(page, "The virtual hand brings the arm back…").waitFor();
  await button(page, "Virtual hand: bring it to the start").waitFor();
  await button(page, "Make the arm stiff").click();
  await robotReady(page);
  await hangUp(phone);
});

test("a task is renamed, and deleted only after a question", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "Old name");
  await linkNamed(page, "More").click();
  await page.getByLabel("Name of the task").fill("New name");
  await button(page, "Rename").click();
  await page.getByRole("link", { name: "Back" }).click();
  await heading(page, "New name").waitFor();
  await linkNamed(page, "More").click();
  await button(page, "Delete this task").click();
  await button(page, "No, keep it").click();
  await button(page, "Delete this task").click();
  await inspect(page, "teach-delete");
  await button(page, "Yes, delete").click();
  await heading(page, "Teach").waitFor();
  await page.getByRole("link", { name: "Open task New name" }).waitFor({ state: "detached" });
  await hangUp(phone);
});
