// A phone: headless Chromium with a worker's screen, pointed at the server under test.
import assert from "node:assert/strict";
import { mkdir } from "node:fs/promises";
import path from "node:path";
import sparticuz from "@sparticuz/chromium";
import { chromium } from "playwright-core";

export const BASE_URL = process.env.BASE_URL ?? "http://127.0.0.1:8080/";
const SCREENSHOTS = process.env.SCREENSHOTS;

/** Longer than anything the app waits for, except trainings and whole motions. */
const PATIENCE_MS = 60_000;

export const SMALL = { width: 360, height: 640 };
export const USUAL = { width: 390, height: 844 };
export const TABLET = { width: 820, height: 1180 };
export const SIZES = { small: SMALL, usual: USUAL, tablet: TABLET };

/** The size on which a spec file's flows are done: always the same for one file, and each size for
 *  some of them. `SIZE=small` and so on does all of them on one. */
function ownSize() {
  const wanted = SIZES[process.env.SIZE];
  if (wanted) return wanted;
  const name = path.basename(process.argv[1] ?? "");
  const sum = [...name].reduce((total, letter) => total + letter.charCodeAt(0), 0);
  return Object.values(SIZES)[sum % 3];
}

/** Opens a browser for one spec file; `close` it in `after`. The package's own arguments are meant
 *  for a cloud function: one process for everything, and no web security. We want neither. */
export async function openBrowser(more = []) {
  return chromium.launch({
    args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", ...more],
    executablePath: await sparticuz.executablePath(),
    headless: true,
  });
}

/** A fresh phone without history. Errors in the page make the test fail at `hangUp`. It keeps the
 *  app for a start without the server only when told to, since requests could not be watched then. */
export async function newPhone(
  browser,
  { viewport = ownSize(), colorScheme = "light", locale = "en-GB", keepsApp = false } = {},
) {
  const context = await browser.newContext({
    viewport,
    colorScheme,
    deviceScaleFactor: 2,
    hasTouch: true,
    isMobile: true,
    locale,
    serviceWorkers: keepsApp ? "allow" : "block",
  });
  context.setDefaultTimeout(PATIENCE_MS);
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  return { page, errors, context };
}

/** Closes the phone and checks that its pages ran without an error. */
export async function hangUp(phone) {
  await phone.context.close();
  assert.deepEqual(phone.errors, [], "errors in the page");
}

/** Opens the app; every address is in the fragment. */
export async function openApp(page, fragment = "#/teach", base = BASE_URL) {
  await page.goto(new URL("/", base).href + fragment);
}

/** Keeps a picture of the screen when a folder for pictures is given. */
export async function picture(page, name) {
  if (!SCREENSHOTS) return;
  await mkdir(SCREENSHOTS, { recursive: true });
  await page.screenshot({ path: path.join(SCREENSHOTS, `${name}.png`) });
}

/** Resolves when what was changed is on the screen. */
export async function drawn(page) {
  await page.evaluate(() => document.fonts.ready.then(() => new Promise(requestAnimationFrame)));
}

/** Polls the condition in the page until it holds. */
export async function until(page, what, condition) {
  const end = Date.now() + PATIENCE_MS;
  while (!(await condition())) {
    assert.ok(Date.now() < end, `waited too long until ${what}`);
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
}

/** A phone that can draw nothing in three dimensions; to be said before the app is opened. */
export async function withoutWebGl(page) {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
      apply: (real, element, args) =>
        args[0].startsWith("webgl") ? null : real.apply(element, args),
    });
  });
}
