// A cell with several robots: the phone is told once which one it stands at, and remembers it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser } from "../support/phone.mjs";
import { button, heading, robotReady } from "../support/steps.mjs";

// A second server with the virtual robots "left" (Left arm) and "right" (Right arm) and others as
// its configuration file says. Whoever runs the specs starts it.
const { CELL_URL } = process.env;

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const stopOf = (page, path) =>
  page.waitForRequest((one) => new URL(one.url()).pathname === `/api/v1${path}`);

test("a phone chooses its robot once, shows it, and stops only that one", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page, "#/teach", CELL_URL);
  await heading(page, "Robots").waitFor();
  await page.getByRole("button", { name: /^Left arm/ }).waitFor();
  await inspect(page, "robots-choose");
  const everyRobot = stopOf(page, "/robots/stop");
  await button(page, "Stop").click();
  assert.equal((await (await everyRobot).response()).status(), 204);

  await page.getByRole("button", { name: /^Right arm/ }).click();
  await heading(page, "Teach").waitFor();
  await robotReady(page);
  await page.reload();
  await heading(page, "Teach").waitFor();
  await robotReady(page);
  await inspect(page, "robots-teach");
  const thisRobot = stopOf(page, "/robots/right/stop");
  await button(page, "Stop").click();
  assert.equal((await (await thisRobot).response()).status(), 204);

  await page.getByRole("link", { name: "Robot Right arm. Choose another robot" }).click();
  const right = page.getByRole("button", { name: /^Right arm/ });
  await right.waitFor();
  assert.equal(await right.getAttribute("aria-pressed"), "true");
  await inspect(page, "robots-list");
  await page.getByRole("button", { name: /^Left arm/ }).click();
  await page.getByRole("link", { name: /^Robot Left arm/ }).waitFor();
  await robotReady(page);
  await hangUp(phone);
});
