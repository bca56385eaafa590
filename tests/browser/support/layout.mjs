// What must hold on every screen. In each look: nothing cut off or on top of something else, big
// targets, readable text, everything named, nothing that axe-core objects to. And once: usable by
// keyboard, with text of twice the size, with colours of the person's own, and without motion.
import assert from "node:assert/strict";
import { accessible } from "./accessible.mjs";
import { findFaults } from "./faults.mjs";
import { drawn, picture, SMALL, USUAL } from "./phone.mjs";
import { barriers } from "./reach.mjs";

const LOOKS = [
  { suffix: "-small-dark", viewport: SMALL, colorScheme: "dark" },
  { suffix: "", viewport: USUAL, colorScheme: "light" },
];

/** What this spec has looked at: a take is recorded three times, its screens are the same ones. */
const inspected = new Set();

/** Checks the screen in all looks and keeps a picture of each, once for each name; the phone's own
 *  look is left. */
export async function inspect(page, name) {
  if (inspected.has(name)) return;
  inspected.add(name);
  const own = page.viewportSize();
  for (const { suffix, viewport, colorScheme } of LOOKS) {
    await look(page, viewport, colorScheme);
    const faults = await page.evaluate(findFaults, {});
    await picture(page, name + suffix);
    assert.deepEqual(faults, [], `${name}${suffix}`);
    await accessible(page, name + suffix);
  }
  await look(page, SMALL, "light");
  assert.deepEqual(await barriers(page), [], name);
  await look(page, own, "light");
}

/** Shows the page in this size and scheme, and waits until it is drawn. */
export async function look(page, viewport, colorScheme) {
  await page.setViewportSize(viewport);
  await page.emulateMedia({ colorScheme });
  await drawn(page);
}
