// A walk over every page and state that the screenshots show, on all sizes: what flows meet only in
// their own size and order. On each also: on its side, and by the Tab key alone.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { violations } from "../support/accessible.mjs";
import { findFaults } from "../support/faults.mjs";
import { look } from "../support/layout.mjs";
import {
  BASE_URL,
  hangUp,
  newPhone,
  openBrowser,
  SMALL,
  TABLET,
  USUAL,
} from "../support/phone.mjs";
import { barriers } from "../support/reach.mjs";
import { enter, readyForStates, statesOf } from "../support/states.mjs";
import { makeWorld } from "../support/world.mjs";

const ON_ITS_SIDE = { width: SMALL.height, height: SMALL.width };

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test("every page and state holds on every size, lying or standing", async () => {
  const world = await makeWorld();
  const phone = await newPhone(browser, { viewport: USUAL });
  const setStage = await readyForStates(phone.context);
  const faults = [];
  for (const state of statesOf(world)) {
    faults.push(...(await walk(phone.page, setStage, state)));
  }
  assert.deepEqual(faults, []);
  await hangUp(phone);
});

async function walk(page, setStage, state) {
  const found = [];
  const note = (where, faults) =>
    found.push(...faults.map((one) => `${state.name} ${where}: ${one}`));
  await look(page, USUAL, "light");
  try {
    await enter(page, setStage, state, BASE_URL);
  } catch (error) {
    return [`${state.name} is not reached: ${error.message}`];
  }
  for (const [where, viewport, scheme] of [
    ["small", SMALL, "light"],
    ["tablet", TABLET, "dark"],
    ["usual", USUAL, "dark"],
  ]) {
    await look(page, viewport, scheme);
    note(where, await page.evaluate(findFaults, {}));
  }
  note(
    "by axe",
    (await violations(page)).map((one) => JSON.stringify(one)),
  );
  await look(page, ON_ITS_SIDE, "light");
  note("on its side", await page.evaluate(findFaults, { large: true }));
  await look(page, SMALL, "light");
  note("small", await barriers(page));
  return found;
}

test("the Tab key leads through the page and comes to Stop last", async () => {
  const phone = await newPhone(browser, { viewport: SMALL });
  const { page } = phone;
  await page.goto(new URL("/#/teach/new", BASE_URL).href);
  await page.locator(".field input").waitFor();
  const visited = [];
  do {
    await page.keyboard.press("Tab");
    visited.push(
      await page.evaluate(() => {
        const { className, tagName } = document.activeElement;
        return className || tagName;
      }),
    );
    assert.ok(visited.length < 30, `Tab never comes to Stop: ${visited.join(", ")}`);
  } while (visited.at(-1) !== "stop");
  assert.ok(visited.includes("INPUT"), visited.join(", "));
  await hangUp(phone);
});
