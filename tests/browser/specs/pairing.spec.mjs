// A phone in the network has to show the code before it may do anything.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser } from "../support/phone.mjs";
import { button, heading } from "../support/steps.mjs";

// A second server that listens on the network, and its code. Whoever runs the specs starts it.
const { PAIRING_URL, PAIRING_CODE } = process.env;
const options = {
  skip: PAIRING_URL && PAIRING_CODE ? false : "PAIRING_URL and PAIRING_CODE are not set",
};

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test(
  "without the code nothing is shown, a wrong code is refused, the right one opens",
  options,
  async () => {
    const phone = await newPhone(browser);
    const { page } = phone;
    await openApp(page, "#/teach", PAIRING_URL);
    await heading(page, "Connect this phone").waitFor();
    await inspect(page, "pairing");
    await page
      .getByLabel("Code")
      .fill(PAIRING_CODE.replace(/^./, (digit) => (digit === "0" ? "1" : "0")));
    await button(page, "Connect").click();
    await page.getByRole("alert").getByText("What to do").waitFor();
    await inspect(page, "pairing-refused");
    assert.ok(await button(page, "Stop").isVisible());
    await page.getByLabel("Code").fill(PAIRING_CODE);
    await button(page, "Connect").click();
    await heading(page, "Teach").waitFor();
    await hangUp(phone);
  },
);

test(
  "the code in the address of the QR picture pairs without typing and leaves no trace",
  options,
  async () => {
    const phone = await newPhone(browser);
    const { page } = phone;
    await openApp(page, `#pair=${PAIRING_CODE}`, PAIRING_URL);
    await heading(page, "Teach").waitFor();
    assert.ok(!page.url().includes(PAIRING_CODE));
    await page.reload();
    await heading(page, "Teach").waitFor();
    await hangUp(phone);
  },
);
