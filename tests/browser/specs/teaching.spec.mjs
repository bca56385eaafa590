// What makes teaching forgiving: a pause, cut ends, pictures, and the way back from a decision.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { json, post, recording } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { BASE_URL, hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import { button, figure, heading, linkNamed, newTask, robotReady } from "../support/steps.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Seven seconds, of which the arm moves for four in the middle. */
function withRests() {
  const rows = Array.from({ length: 701 }, (_, index) => {
    const moving = Math.min(4, Math.max(0, index / 100 - 1.5));
    const swing = 10 * (1 - Math.cos((Math.PI * moving) / 4));
    return [index / 100, swing, 8 + swing / 2, 24, 0, -45, 0].join(",");
  });
  return `${recording().split("\n")[0]}\n${rows.join("\n")}\n`;
}

async function uploaded(name, text) {
  const task = await post("/tasks", json({ name }));
  const path = `/tasks/${task.id}/demonstrations/upload?name=take.csv`;
  const file = { body: text, headers: { "Content-Type": "text/csv" } };
  return { task, take: await post(path, file) };
}

test("standing still at the ends is cut with one press, and the whole take comes back", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  const { task, take } = await uploaded("Cut the ends", withRests());
  await openApp(page, `#/teach/${task.id}/takes/${take.id}`);
  await page.getByText(/^The arm stands still for 1\.\d s at the beginning/).waitFor();
  const accept = button(page, "Cut that away");
  await accept.scrollIntoViewIfNeeded();
  await inspect(page, "teach-trim-proposed");
  await accept.click();
  await page.getByText(/^Cut away: 1\.\d s at the beginning, 1\.\d s at the end/).waitFor();
  const used = Number.parseFloat(await figure(page, "Used"));
  assert.ok(used > 4 && used < 5.5, `${used} s are used`);
  await inspect(page, "teach-trim-cut");
  await page.reload();
  await button(page, "Whole take again").click();
  await accept.waitFor();

  await page.getByText("Cut the ends", { exact: true }).last().click();
  const begins = page.getByRole("slider", { name: "Begins at" });
  await begins.waitFor();
  assert.ok(await button(page, "Cut").isDisabled());
  for (let press = 0; press < 3; press += 1) await button(page, "Begins at: +0.1 s").click();
  await button(page, "Ends at: −0.1 s").click();
  assert.equal(await begins.getAttribute("aria-valuetext"), "0.3 s");
  await button(page, "Cut").scrollIntoViewIfNeeded();
  await inspect(page, "teach-trim-by-hand");
  await button(page, "Cut").click();
  await page.getByText("Cut away: 0.3 s at the beginning, 0.1 s at the end.").waitFor();
  await hangUp(phone);
});

test("a recording is paused, shows how far the arm is off, and goes on from the same place", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await robotReady(page);
  const task = await post("/tasks", json({ name: "Held up" }));
  const handAt = (script, seed = 1) =>
    post("/robots/virtual/virtual-hand", json({ action: "return", script, seed }));
  // A hand that is told to come back by the interface stands for a person's.
  await post("/robots/virtual/lead-through", json({ active: true }));
  await handAt("f1");
  const handIsIdle = () =>
    until(page, "the hand is done", async () => {
      const robot = await fetch(new URL("/api/v1/robots/virtual", BASE_URL));
      return (await robot.json()).hand === "idle";
    });
  await handIsIdle();
  const take = await post(`/tasks/${task.id}/demonstrations`, json({}));
  await openApp(page, `#/teach/${task.id}/takes/${take.id}`);
  await page.getByRole("timer").waitFor();
  await button(page, "Pause").click();
  await page.getByText("Paused", { exact: true }).waitFor();
  await page.getByText("The arm is where you paused.").waitFor();
  await inspect(page, "teach-paused-here");
  const elapsed = await page.getByRole("timer").innerText();

  await handAt("f3", 7);
  await handIsIdle();
  await page.getByText(/^Joint \d is \d+\.\d° from where you paused/).waitFor();
  assert.ok(await button(page, "Go on").isDisabled());
  await inspect(page, "teach-paused-off");
  await page.reload();
  await page.getByText("Paused", { exact: true }).waitFor();
  assert.equal(await page.getByRole("timer").innerText(), elapsed, "nothing is recorded meanwhile");

  await handAt("f1");
  await page.getByText("The arm is where you paused.").waitFor();
  await handIsIdle();
  await button(page, "Go on").click();
  await page.getByText("Recording", { exact: true }).waitFor();
  await button(page, "Stop recording").click();
  assert.equal(await figure(page, "Pauses"), "1");
  await hangUp(phone);
});

/** A picture as a file, painted in the page. */
async function paintedPhoto(page) {
  const address = await page.evaluate(() => {
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width: 1600, height: 1200 });
    const brush = canvas.getContext("2d");
    brush.fillStyle = "#2b6f5c";
    brush.fillRect(0, 0, 1600, 1200);
    brush.fillStyle = "#d9b44a";
    brush.fillRect(500, 250, 600, 700);
    return canvas.toDataURL("image/png");
  });
  const buffer = Buffer.from(address.split(",")[1], "base64");
  return { name: "machine.png", mimeType: "image/png", buffer };
}

test("a task has a picture from its beginning, small, and it can be taken away", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await linkNamed(page, "New task").click();
  await page.getByLabel("Name of the task").fill("With a picture");
  await page.getByLabel("Take a photo").setInputFiles(await paintedPhoto(page));
  await page.locator("img.picture-shown").waitFor();
  await inspect(page, "teach-new-task-picture");
  await button(page, "Create task").click();
  await heading(page, "Record a take").waitFor();
  await linkNamed(page, "Teach").click();
  const row = page.getByRole("link", { name: "Open task With a picture" });
  const shown = row.locator("img");
  await shown.waitFor();
  await until(page, "the picture is loaded", () => shown.evaluate((image) => image.complete));
  const width = await shown.evaluate((image) => image.naturalWidth);
  assert.equal(width, 512);
  const file = await fetch(new URL(await shown.getAttribute("src"), BASE_URL));
  assert.equal(file.headers.get("content-type"), "image/jpeg");
  assert.ok((await file.arrayBuffer()).byteLength <= 60_000);
  await shown.scrollIntoViewIfNeeded();
  await inspect(page, "teach-tasks-pictures");

  await row.click();
  await linkNamed(page, "More").click();
  await button(page, "Remove the picture").scrollIntoViewIfNeeded();
  await inspect(page, "teach-more-picture");
  await button(page, "Remove the picture").click();
  await page.getByText("A picture helps to find the task without reading.").waitFor();
  await linkNamed(page, "Teach").click();
  await row.locator('[data-initials="WA"]').waitFor();
  await hangUp(phone);
});

test("discarding a take and deleting a task are undone with one press", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  const { task, take } = await uploaded("Not like that", recording());
  await openApp(page, `#/teach/${task.id}/takes/${take.id}`);
  await button(page, "Discard").click();
  await page.getByText("Take 1 is discarded.").waitFor();
  await inspect(page, "teach-undo");
  await button(page, "Undo").click();
  await page.getByRole("link", { name: "Take 1, Keep it?" }).waitFor();

  await linkNamed(page, "More").click();
  await button(page, "Delete this task").click();
  await button(page, "Yes, delete").click();
  await page.getByText("“Not like that” is deleted.").waitFor();
  const row = page.getByRole("link", { name: "Open task Not like that" });
  await row.waitFor({ state: "detached" });
  await inspect(page, "teach-undo-delete");
  await button(page, "Undo").click();
  await row.click();
  await page.getByRole("link", { name: "Take 1, Keep it?" }).waitFor();
  await hangUp(phone);
});

test("a motion is trained again when its takes were cut since", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await newTask(page, "Cut after training");
  const id = /#\/teach\/([^/]+)/.exec(page.url())[1];
  const file = { body: withRests(), headers: { "Content-Type": "text/csv" } };
  const take = await post(`/tasks/${id}/demonstrations/upload?name=take.csv`, file);
  await post(`/demonstrations/${take.id}/keep`);
  const { job } = await post(`/tasks/${id}/models`, json({}));
  const isDone = async () => {
    const asked = await fetch(new URL(`/api/v1/jobs/${job.id}`, BASE_URL));
    return (await asked.json()).state === "succeeded";
  };
  await until(page, "the training is done", isDone);
  await page.reload();
  await button(page, "Run it").waitFor();
  await page.getByRole("link", { name: "Take 1, Kept" }).click();
  await button(page, "Cut that away").click();
  await button(page, "Whole take again").waitFor();
  await linkNamed(page, "Back to the takes").click();
  await page.getByText(/^Takes were cut or chosen anew/).waitFor();
  await button(page, "Train").waitFor();
  await inspect(page, "teach-cut-since");
  await hangUp(phone);
});
