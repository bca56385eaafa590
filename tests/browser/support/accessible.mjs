// What axe-core finds on a screen: nothing may be wrong by WCAG 2.0 to 2.2 at levels A and AA, nor
// against what it calls best practice.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";

const SOURCE = readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const OPTIONS = {
  runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"],
  rules: { "target-size": { enabled: true } },
  resultTypes: ["violations"],
};

/** Checks the screen as it is shown now. */
export async function accessible(page, name) {
  assert.deepEqual(await violations(page), [], `axe: ${name}`);
}

/** What axe-core objects to on the screen as it is shown now. */
export async function violations(page) {
  if (await page.evaluate(() => !("axe" in window))) await page.evaluate(await SOURCE);
  return page.evaluate(async (options) => {
    const found = await window.axe.run(document, options);
    return found.violations.map(({ id, help, nodes }) => ({
      id,
      help,
      where: nodes.slice(0, 3).map(({ html, failureSummary }) => `${html} ${failureSummary}`),
    }));
  }, OPTIONS);
}
