// An hour of live messages leaves a phone's memory as it was.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { get } from "../support/api.mjs";
import { GROWTH_BYTES, heapBytes, kilobytes, report } from "../support/budgets.mjs";
import { taskFromFiles } from "../support/files.mjs";
import { drawn, hangUp, newPhone, openBrowser, BASE_URL } from "../support/phone.mjs";

/** Twenty messages a second for an hour. */
const MESSAGES = 72_000;
/** After a tenth of them everything that is made once has been made. */
const WARM_UP = MESSAGES / 10;
const BURST = 400;

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Keeps the page's live socket at hand, so that messages can be put into it as if they had come
 *  over the network. */
function keepSocket() {
  const Native = window.WebSocket;
  window.WebSocket = class extends Native {
    constructor(...address) {
      super(...address);
      if (String(address[0]).includes("/live?")) window.live = this;
    }
  };
}

/** Runs in the page: one burst of messages in each picture's time, so that each burst is drawn. */
async function feed({ messages, burst, robot, take }) {
  const say = (message) =>
    window.live.onmessage(new MessageEvent("message", { data: JSON.stringify(message) }));
  for (let sent = 0; sent < messages; sent += burst) {
    for (let number = sent; number < sent + burst; number += 1) {
      const joints_deg = robot.joints_deg.map(
        (own, joint) => own + 9 * Math.sin(number / 50 + joint),
      );
      // Later and later in the hour, however quickly the messages come.
      const age_ms = (burst - (number - sent)) / 100;
      say({ type: "robot", robot: { ...robot, joints_deg, age_ms } });
      if (number % 10 === 0) {
        say({ type: "demonstration", demonstration: { ...take, duration_s: number / 20 } });
      }
    }
    await new Promise(requestAnimationFrame);
  }
  return window.live.readyState;
}

test("an hour of messages while recording does not make the page grow", async (run) => {
  const { id: task } = await taskFromFiles("An hour");
  const [known] = await get(`/tasks/${task}/demonstrations`);
  const take = { ...known, state: "recording" };
  const robot = { ...(await get("/robots/virtual")), state: "guiding" };
  const phone = await newPhone(browser);
  const { page, context } = phone;
  await context.addInitScript(keepSocket);
  // A take of a file, which the page is told is still being recorded.
  await context.route(`**/demonstrations/${take.id}`, (route) => route.fulfill({ json: take }));
  await page.goto(new URL(`/#/teach/${task}/takes/${take.id}`, BASE_URL).href);
  await page.locator(".recording-on").waitFor();
  await page.locator(".live-traces canvas").waitFor();
  const devtools = await context.newCDPSession(page);
  const after = async (messages) => {
    await page.evaluate(feed, { messages, burst: BURST, robot, take });
    await drawn(page);
    return heapBytes(devtools);
  };
  const warm = await after(WARM_UP);
  const end = await after(MESSAGES - WARM_UP);
  assert.match(await page.getByRole("timer").innerText(), /^5\d:\d\d/, "all was taken in");
  await report(run, `memory ${kilobytes(warm)} after six minutes, ${kilobytes(end)} after an hour`);
  assert.ok(end - warm < GROWTH_BYTES, `${end - warm} bytes more after an hour`);
  await hangUp(phone);
});
