// The app on a phone's home screen: what makes it installable, what it shows without the server,
// that it never sends anything late, and how a new build comes.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { inspect } from "../support/layout.mjs";
import { openNetwork } from "../support/network.mjs";
import { BASE_URL, hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import { button, heading, linkNamed, robotReady } from "../support/steps.mjs";

const COMMAND = /^(POST|PUT|PATCH|DELETE) /;

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const get = (path) => fetch(new URL(path, BASE_URL));

/** Width and height of a PNG file, from its header. */
async function sizeOf(path) {
  const response = await get(path);
  assert.equal(response.headers.get("content-type"), "image/png", path);
  const bytes = Buffer.from(await response.arrayBuffer());
  assert.equal(bytes.subarray(1, 4).toString(), "PNG", path);
  return `${bytes.readUInt32BE(16)}x${bytes.readUInt32BE(20)}`;
}

/** The page is controlled by a service worker that is ready. */
async function appKept(page) {
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  await until(page, "the worker controls the page", () =>
    page.evaluate(() => navigator.serviceWorker.controller !== null),
  );
}

/** Waits until what the robot said is on the phone. */
async function stateKept(page) {
  await until(page, "the state is kept", () =>
    page.evaluate(() => localStorage.getItem("team.last-known")?.includes("joints_deg") ?? false),
  );
}

test("the manifest is complete and its icons are of the size that it says", async () => {
  const response = await get("/manifest.webmanifest");
  assert.equal(response.headers.get("content-type"), "application/manifest+json");
  const manifest = await response.json();
  for (const member of ["name", "short_name", "description", "lang", "background_color", "id"]) {
    assert.equal(typeof manifest[member], "string", member);
  }
  assert.ok(manifest.short_name.length <= 12, "it fits below an icon");
  assert.deepEqual(
    [manifest.display, manifest.start_url, manifest.scope],
    ["standalone", "/", "/"],
  );
  assert.match(manifest.theme_color, /^#[0-9a-f]{6}$/);
  assert.deepEqual(
    manifest.shortcuts.map((one) => [one.name, one.url]),
    [
      ["Teach", "/#/teach"],
      ["Run", "/#/run"],
    ],
  );
  const icons = manifest.icons.filter((icon) => icon.type === "image/png");
  const kinds = icons.map((icon) => `${icon.sizes} ${icon.purpose}`);
  assert.deepEqual(kinds, ["192x192 any", "512x512 any", "512x512 maskable"]);
  for (const icon of icons) assert.equal(await sizeOf(icon.src), icon.sizes, icon.src);
});

test("the page says what phones ask for, and lets nothing in from elsewhere", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await heading(page, "Teach").waitFor();
  const head = await page.evaluate(() => {
    const content = (name) => document.querySelector(`meta[name="${name}"]`)?.content ?? "";
    const touch = document.querySelector('link[rel="apple-touch-icon"]')?.getAttribute("href");
    const { lang, clientWidth } = document.documentElement;
    const names = ["viewport", "theme-color", "description", "apple-mobile-web-app-title"];
    return { touch, lang, clientWidth, ...Object.fromEntries(names.map((n) => [n, content(n)])) };
  });
  assert.match(head.viewport, /width=device-width/);
  assert.doesNotMatch(head.viewport, /user-scalable=no|maximum-scale/, "people may zoom");
  assert.match(head["theme-color"], /^#/);
  assert.equal(head.lang, "en");
  assert.ok(head.description && head["apple-mobile-web-app-title"]);
  assert.equal(head.clientWidth, page.viewportSize().width);
  assert.equal(await sizeOf(head.touch), "180x180");
  for (const path of ["/", "/sw.js", "/manifest.webmanifest"]) {
    const { headers } = await get(path);
    assert.match(headers.get("content-security-policy"), /default-src 'self'/, path);
    assert.equal(headers.get("x-content-type-options"), "nosniff", path);
    assert.equal(headers.get("cache-control"), "no-cache", path);
  }
  const worker = await get("/sw.js");
  assert.match(worker.headers.get("content-type"), /^text\/javascript/);
  await hangUp(phone);
});

test("without the server the app shows what it knew, says that it is old, and sends nothing later", async () => {
  const network = await openNetwork(BASE_URL);
  const phone = await newPhone(browser, { keepsApp: true });
  const { page } = phone;
  await openApp(page, "#/run", network.url);
  await robotReady(page);
  await appKept(page);
  await stateKept(page);

  await network.cut();
  await page.reload();
  await heading(page, "No connection").waitFor();
  await page.getByText("What is shown is old.").waitFor();
  const bar = page.getByRole("region", { name: "Robot" });
  await bar.getByText("Offline", { exact: true }).waitFor();
  const state = page.getByText(/^Ready, \d+ s ago$/).last();
  const first = await state.innerText();
  await until(page, "the age grows", async () => (await state.innerText()) !== first);
  for (const name of ["Teach", "Run"]) {
    assert.ok(await button(page, name).isDisabled(), name);
  }
  assert.equal(await page.getByText("This phone is not connected to the server.").count(), 2);
  await inspect(page, "offline");

  network.requests.length = 0;
  await button(page, "Stop").click();
  await page.getByText("Use the emergency stop of the robot").waitFor();
  await network.restore();
  await heading(page, "Run").waitFor();
  await robotReady(page);
  assert.ok(network.requests.includes("GET /api/v1/session"));
  const late = network.requests.filter((request) => COMMAND.test(request));
  assert.deepEqual(late, [], "what was pressed without the server is not sent later");
  await network.cut();
  await hangUp(phone);
});

test("what the interface answers is never kept", async () => {
  const phone = await newPhone(browser, { keepsApp: true });
  const { page } = phone;
  await openApp(page);
  await robotReady(page);
  await appKept(page);
  const kept = await page.evaluate(async () => {
    const names = await caches.keys();
    const stores = await Promise.all(names.map((name) => caches.open(name)));
    const requests = await Promise.all(stores.map((store) => store.keys()));
    return requests.flat().map((request) => new URL(request.url).pathname);
  });
  assert.ok(kept.includes("/") && kept.some((path) => path.startsWith("/assets/")), kept.join());
  assert.deepEqual(
    kept.filter((path) => !/^\/(assets\/.+|language)?$/.test(path)),
    [],
  );
  await hangUp(phone);
});

test("a new build waits for a person, who is told and decides", async () => {
  let newer = false;
  const network = await openNetwork(BASE_URL, (path, text) =>
    newer && path === "/sw.js"
      ? text.replaceAll(/\/assets\/index-[\w-]+\.js/g, "/assets/new.js")
      : text,
  );
  const phone = await newPhone(browser, { keepsApp: true });
  const { page } = phone;
  await openApp(page, "#/teach", network.url);
  await robotReady(page);
  await appKept(page);
  await page.evaluate(() => (window.before = true));
  const isBefore = () => page.evaluate(() => window.before === true);

  newer = true;
  await network.cut();
  await page.getByRole("region", { name: "Robot" }).getByText("Offline").waitFor();
  await network.restore();
  await page.getByText("A new version of TEAM is ready").waitFor();
  await inspect(page, "new-version");
  assert.ok(await isBefore(), "the page was not loaded anew by itself");
  await button(page, "Load it now").click();
  await until(page, "the page is loaded anew", async () => !(await isBefore()));
  await heading(page, "Teach").waitFor();
  await network.cut();
  await hangUp(phone);
});

test("the way to set up phones is on the first page, and sounds can be switched off", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await linkNamed(page, "Phones and sounds").click();
  await heading(page, "Phones").waitFor();
  await page.getByText("Only this computer can reach the server").waitFor();
  await inspect(page, "phones");
  await button(page, "Switch sounds off").click();
  await page.reload();
  await page.getByText("Sounds and vibration are off").waitFor();
  await hangUp(phone);
});
