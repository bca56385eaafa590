// A phone on its way to HTTPS: over plain HTTP to the certificate, and with it to the secured app.
import assert from "node:assert/strict";
import { createHash, X509Certificate } from "node:crypto";
import { test } from "node:test";
import { inspect } from "../support/layout.mjs";
import { hangUp, newPhone, openApp, openBrowser, until } from "../support/phone.mjs";
import { button, heading } from "../support/steps.mjs";

// A server with --https on the network, and its code. Whoever runs the specs starts it.
const { HTTPS_URL, HTTPS_CODE } = process.env;
const options = {
  skip: HTTPS_URL && HTTPS_CODE ? false : "HTTPS_URL and HTTPS_CODE are not set",
};

/** A name in the network: pages under it are not trusted as those of this computer would be. */
const HOST = "cell.test";
const NETWORK = `--host-resolver-rules=MAP ${HOST} 127.0.0.1`;

function address(scheme) {
  const url = new URL(HTTPS_URL);
  return `${scheme}://${HOST}:${url.port}/`;
}

/** The option that installs a certificate in this browser. */
async function installed() {
  const response = await fetch(new URL("/team-cell.crt", HTTPS_URL));
  const certificate = new X509Certificate(Buffer.from(await response.arrayBuffer()));
  const key = certificate.publicKey.export({ type: "spki", format: "der" });
  const pin = createHash("sha256").update(key).digest("base64");
  return `--ignore-certificate-errors-spki-list=${pin}`;
}

test("a phone without the certificate is led to it, and can go on without", options, async (t) => {
  const browser = await openBrowser([NETWORK]);
  t.after(() => browser.close());
  const phone = await newPhone(browser);
  const { page } = phone;
  await openApp(page, `#/join/${HTTPS_CODE}`, address("http"));
  await heading(page, "Set up this phone").waitFor();
  assert.ok(!page.url().includes(HTTPS_CODE));
  await page.getByText("Not installed yet").waitFor();
  assert.equal(await button(page, "Open TEAM").count(), 0);
  const file = await page.getByRole("link", { name: "Get the certificate" }).getAttribute("href");
  const offered = await fetch(new URL(file, HTTPS_URL));
  assert.equal(offered.headers.get("content-type"), "application/x-x509-ca-cert");
  await page.getByRole("radio", { name: "iPhone" }).check();
  await page.getByText("Certificate Trust Settings").waitFor();
  await inspect(page, "join-certificate");

  await button(page, "Go on without").click();
  await heading(page, "Teach").waitFor();
  await page.getByText("This connection is not encrypted").waitFor();
  await inspect(page, "teach-not-encrypted");
  await button(page, "Understood").click();
  await page.reload();
  await heading(page, "Teach").waitFor();
  assert.equal(await page.getByText("This connection is not encrypted").count(), 0);
  await hangUp(phone);
});

test(
  "a phone with the certificate goes on to HTTPS and shows the next one in",
  options,
  async (t) => {
    const browser = await openBrowser([NETWORK, await installed()]);
    t.after(() => browser.close());
    const phone = await newPhone(browser, { keepsApp: true });
    const { page } = phone;
    await openApp(page, `#/join/${HTTPS_CODE}`, address("http"));
    await page.getByText("The certificate is installed").waitFor();
    await button(page, "Open TEAM").click();
    await page.waitForURL(`${address("https")}**`);
    await heading(page, "Teach").waitFor();
    assert.ok(await page.evaluate(() => window.isSecureContext));
    const cookies = await phone.context.cookies(address("https"));
    assert.deepEqual(
      cookies.map(({ name, secure, httpOnly }) => [name, secure, httpOnly]),
      [["__Host-team_session", true, true]],
    );
    await until(page, "the app is kept", () =>
      page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.active != null),
    );

    await openApp(page, "#/join", address("https"));
    const picture = page.getByRole("img", { name: "QR code that connects another phone" });
    await until(page, "the picture is there", () =>
      picture.evaluate((image) => image.complete && image.naturalWidth > 100),
    );
    await page.getByText(address("http"), { exact: true }).waitFor();
    await page.getByText("The connection is encrypted.").waitFor();
    await inspect(page, "phones-encrypted");
    await hangUp(phone);
    await browser.close();
  },
);
