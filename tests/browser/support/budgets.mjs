// What the app may cost a phone, and how the costs are measured.
import { appendFile } from "node:fs/promises";

/** Bytes on the wire until the Teach page is usable. */
export const FIRST_LOAD_BYTES = 120_000;
/** Bytes more that the three-dimensional view may cost, on the first screen that shows it. */
export const ARM_VIEW_BYTES = 250_000;
/** From a touch to the next picture, on a processor made this many times slower. */
export const INTERACTION_MS = 100;
export const SLOWER = 4;
/** By how much the page's memory may grow over an hour of live messages. */
export const GROWTH_BYTES = 1_000_000;

/** Prints a figure, and keeps it in the file that BUDGETS names. */
export async function report(run, words) {
  run.diagnostic(words);
  if (process.env.BUDGETS) await appendFile(process.env.BUDGETS, `${words}\n`);
}

/** Adds up what the network brings, from now on. */
export async function countBytes(page) {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Network.enable");
  const files = new Map();
  devtools.on("Network.responseReceived", ({ requestId, response, type }) => {
    files.set(requestId, { url: response.url, type, bytes: 0 });
  });
  devtools.on("Network.loadingFinished", ({ requestId, encodedDataLength }) => {
    const file = files.get(requestId);
    if (file) file.bytes = encodedDataLength;
  });
  return () => [...files.values()].toSorted((one, other) => other.bytes - one.bytes);
}

export const total = (files) => files.reduce((sum, { bytes }) => sum + bytes, 0);

/** The files and their sizes, as a list for people. */
export function listed(files) {
  return files
    .map(({ url, bytes }) => `  ${kilobytes(bytes)}  ${new URL(url).pathname}`)
    .join("\n");
}

export const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1).padStart(6)} kB`;

/** Starts the browser's own measurement of interactions. Only those of 16 ms or more are reported,
 *  so a press without a report took less. */
export async function watchInteractions(page) {
  await page.evaluate(() => {
    window.interactions = [];
    new PerformanceObserver((list) => {
      for (const { interactionId, duration } of list.getEntries()) {
        if (interactionId) window.interactions.push(duration);
      }
    }).observe({ type: "event", durationThreshold: 16, buffered: false });
  });
}

/** How long the press took from the touch to the next picture: the longest of its events. */
export async function interactionMs(page, press) {
  await page.evaluate(() => (window.interactions.length = 0));
  await press();
  // The report comes after the picture; two more pictures and a turn of the loop are behind it.
  await page.evaluate(
    () =>
      new Promise((resolve) =>
        requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve))),
      ),
  );
  return page.evaluate(() => Math.max(16, ...window.interactions));
}

export function median(values) {
  const sorted = values.toSorted((one, other) => one - other);
  return sorted[Math.floor(sorted.length / 2)];
}

/** The page's JavaScript memory after everything unused was thrown away. */
export async function heapBytes(devtools) {
  await devtools.send("HeapProfiler.collectGarbage");
  await devtools.send("HeapProfiler.collectGarbage");
  const { usedSize } = await devtools.send("Runtime.getHeapUsage");
  return usedSize;
}
