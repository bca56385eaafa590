// Everybody in their own language: chosen on the first screen, kept, and nowhere does a page break
// under longer words.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { json, post, taskFromFiles } from "../support/files.mjs";
import { inspect } from "../support/layout.mjs";
import { BASE_URL, hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import { heading, linkNamed } from "../support/steps.mjs";

// Servers that ask for a code, and with several robots. Whoever runs the specs starts them.
const { PAIRING_URL, CELL_URL } = process.env;

const MOTION_MS = 180_000;
const LANGUAGES = [
  { code: "de", name: "Deutsch" },
  { code: "fr", name: "Français" },
  { code: "it", name: "Italiano" },
];

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const spoken = (page, code) => page.locator(`html[lang="${code}"]`).waitFor({ state: "attached" });
const languages = (page) => heading(page, "Language · Sprache · Langue · Lingua");

/** Presses the language on the page of languages, which any screen can be left for. */
async function speak(page, { code, name }) {
  await openApp(page, "#/language");
  await page.getByRole("button", { name, exact: true }).click();
  await spoken(page, code);
}

async function get(path) {
  const response = await fetch(new URL(`/api/v1${path}`, BASE_URL));
  assert.ok(response.ok, path);
  return response.json();
}

/** Whatever is folded away must fit too. */
const unfold = (page) =>
  page.locator("details").evaluateAll((folded) => folded.forEach((one) => (one.open = true)));

/** The screen of this address, with all that it loads. */
async function show(page, fragment) {
  await page.evaluate((hash) => (location.hash = hash), fragment);
  await until(page, `${fragment} is there`, async () => {
    const loading = await page.locator("main .loading, .actions > .later").count();
    return page.url().endsWith(fragment) && loading === 0;
  });
}

test("the language is chosen on the first screen and survives a reload", async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await heading(page, "Teach").waitFor();
  await spoken(page, "en");
  await linkNamed(page, "Language: English").click();
  await languages(page).waitFor();
  await inspect(page, "language");
  await page.getByRole("button", { name: "Deutsch", exact: true }).click();
  await heading(page, "Anlernen").waitFor();
  await spoken(page, "de");
  await page.reload();
  await heading(page, "Anlernen").waitFor();
  await spoken(page, "de");
  await linkNamed(page, "Sprache: Deutsch").click();
  const german = page.getByRole("button", { name: "Deutsch", exact: true });
  assert.equal(await german.getAttribute("aria-pressed"), "true");
  await linkNamed(page, "Zurück").click();
  await heading(page, "Anlernen").waitFor();
  await speak(page, { code: "en", name: "English" });
  await heading(page, "Teach").waitFor();
  await hangUp(phone);
});

test("a phone that is not connected yet can be read too", { skip: !PAIRING_URL }, async () => {
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page, "#/teach", PAIRING_URL);
  await heading(page, "Connect this phone").waitFor();
  for (const [now, name, code, title] of [
    ["Language: English", "Deutsch", "de", "Telefon verbinden"],
    ["Sprache: Deutsch", "Français", "fr", "Connecter le téléphone"],
    ["Langue\u00a0: Français", "Italiano", "it", "Collega il telefono"],
  ]) {
    await linkNamed(page, now).click();
    await languages(page).waitFor();
    await page.getByRole("button", { name, exact: true }).click();
    await heading(page, title).waitFor();
    await spoken(page, code);
    await inspect(page, `${code}-pairing`);
  }
  await hangUp(phone);
});

test(
  "where there are several robots, the first screen has the choice",
  { skip: !CELL_URL },
  async () => {
    const phone = await newPhone(browser);
    const { page } = phone;
    await openApp(page, "#/teach", CELL_URL);
    await linkNamed(page, "Language: English").click();
    await page.getByRole("button", { name: "Deutsch", exact: true }).click();
    await heading(page, "Roboter").waitFor();
    await inspect(page, "de-robots-choose");
    await page.getByRole("button", { name: /^Left arm/ }).click();
    await heading(page, "Anlernen").waitFor();
    await inspect(page, "de-robots-teach");
    await hangUp(phone);
  },
);

test("a phone is spoken to in its own language, with its country's numbers", async () => {
  for (const [locale, code, title] of [
    ["de-CH", "de", "Anlernen"],
    ["fr-CH", "fr", "Apprendre"],
    ["it-CH", "it", "Insegna"],
    ["pt-BR", "en", "Teach"],
  ]) {
    const phone = await newPhone(browser, { locale });
    await openApp(phone.page);
    await heading(phone.page, title).waitFor();
    await spoken(phone.page, code);
    await hangUp(phone);
  }
});

test("no page breaks in any language", async () => {
  const task = await taskFromFiles("Fräsmaschine beladen");
  const { model } = await post(`/tasks/${task.id}/models`, json({}));
  const [take] = await get(`/tasks/${task.id}/demonstrations`);
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page);
  await until(page, "the model is trained", async () => {
    const { state } = await get(`/models/${model.id}`);
    assert.notEqual(state, "failed");
    return state === "ready";
  });
  const [robot] = await get("/robots");
  const place = crypto.randomUUID();
  const name = `Parkplatz ${place.slice(0, 4)}`;
  await post("/positions", json({ id: place, robot: robot.id, name }));
  const pages = {
    teach: "#/teach",
    "new-task": "#/teach/new",
    task: `#/teach/${task.id}`,
    more: `#/teach/${task.id}/more`,
    record: `#/teach/${task.id}/record`,
    take: `#/teach/${task.id}/takes/${take.id}`,
    model: `#/teach/${task.id}/models/${model.id}`,
    robots: "#/robots",
    run: "#/run",
    setup: `#/run/${task.id}`,
    positions: `#/run/${task.id}/positions`,
    missing: "#/nonsense",
  };
  for (const language of LANGUAGES) {
    await speak(page, language);
    for (const [name, fragment] of Object.entries(pages)) {
      await show(page, fragment);
      await unfold(page);
      await inspect(page, `${language.code}-${name}`);
    }
    await show(page, pages.setup);
    await page.locator("input[type=radio][value=typed]").check();
    await page.locator(".joint-inputs input").first().fill("999");
    await page.locator(".joint-inputs input").nth(1).fill("x");
    await inspect(page, `${language.code}-setup-typed`);
    await page.locator("input[type=radio][value=as_taught]").first().check();
    await page.locator(".actions .button-primary").click();
    await page.locator(".panels").first().waitFor();
    await inspect(page, `${language.code}-preview`);
    await stopped(page, language.code);
    await recording(page, language.code, pages.record);
  }
  await motion(page, { task, model, robot });
  // Other specs begin without a position.
  await fetch(new URL(`/api/v1/positions/${place}`, BASE_URL), { method: "DELETE" });
  await hangUp(phone);
});

/** From the preview into a motion that waits for the button, and stopped there. */
async function stopped(page, code) {
  await page.locator(".actions .button-primary").click();
  await page.getByRole("progressbar").waitFor();
  await inspect(page, `${code}-held`);
  await page.locator("button.stop").click();
  await page.locator("main .figures").waitFor();
  await inspect(page, `${code}-stopped`);
}

/** A recording from its count-in to the question whether it is good. */
async function recording(page, code, fragment) {
  await show(page, fragment);
  await until(page, "the robot is ready", () =>
    page.locator(".actions .button-primary").isEnabled(),
  );
  await page.locator(".actions .button-primary").click();
  await page.locator(".count-in").waitFor();
  await inspect(page, `${code}-count-in`);
  await page.getByRole("timer").waitFor();
  await inspect(page, `${code}-recording`);
  await page.locator(".actions .button-primary").click();
  await page.locator(".panels").first().waitFor();
  await inspect(page, `${code}-review`);
  await post(`/demonstrations/${page.url().split("/").at(-1)}/discard`);
}

/** One motion, looked at in each language: held on its way, and when it is done. */
async function motion(page, { task, model, robot }) {
  const wish = { model_id: model.id, start: "as_taught", goal: "as_taught", speed: 1 };
  const plan = await post("/plans", json({ ...wish, robot: robot.id }));
  // The phone has the control of the robot, so it is the one that asks.
  const phone = await page.evaluate(() => localStorage.getItem("team.phone"));
  const ours = ({ body, headers }) => ({ body, headers: { ...headers, "X-Team-Phone": phone } });
  const id = crypto.randomUUID();
  await post("/reproductions", ours(json({ id, robot: robot.id, plan: plan.plan })));
  await post(`/reproductions/${id}/pace`, ours(json({ paused: true })));
  const fragment = `#/run/${task.id}/motions/${id}`;
  for (const language of LANGUAGES) {
    await speak(page, language);
    await show(page, fragment);
    await page.getByRole("progressbar").waitFor();
    await inspect(page, `${language.code}-moving`);
  }
  await post(`/reproductions/${id}/pace`, ours(json({ paused: false })));
  await page.getByRole("slider").waitFor({ timeout: MOTION_MS });
  for (const language of LANGUAGES) {
    await speak(page, language);
    await show(page, fragment);
    await page.getByRole("slider").waitFor();
    await unfold(page);
    await inspect(page, `${language.code}-result`);
    await show(page, `${fragment}/questions`);
    await inspect(page, `${language.code}-questions`);
    await show(page, "#/dashboard");
    await inspect(page, `${language.code}-dashboard`);
  }
}
