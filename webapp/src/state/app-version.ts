// The app on this phone and its newer builds. A new one never takes over by itself while a page is
// open: a person presses, or it is there at the next start.
import { signal } from "@preact/signals";
import { ownFile } from "./build";
import { snapshots } from "./live";

/** A newer build is on this phone and waits. */
export const updateWaits = signal(false);

let waiting: ServiceWorker | null = null;

/** Only HTTPS pages and those of this very computer are allowed to keep themselves. */
export async function keepApp(language: string): Promise<void> {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  try {
    const registration = await navigator.serviceWorker.register("/sw.js", {
      updateViaCache: "none",
    });
    if (registration.waiting) await consider(registration.waiting);
    registration.addEventListener("updatefound", () => watch(registration.installing));
    watch(registration.installing);
    // A server that was away may have come back as a newer one.
    snapshots.subscribe((count) => {
      if (count > 0) registration.update().catch(() => undefined);
    });
    const { active } = await navigator.serviceWorker.ready;
    active?.postMessage({ type: "language", value: language });
  } catch {
    // A browser that keeps nothing still works as long as the server answers.
  }
}

/** Loads the page anew with the build that waits. */
export function loadNewBuild(): void {
  if (waiting === null) return location.reload();
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), {
    once: true,
  });
  waiting.postMessage({ type: "take over" });
}

function watch(worker: ServiceWorker | null): void {
  worker?.addEventListener("statechange", () => {
    if (worker.state === "installed" && navigator.serviceWorker.controller) void consider(worker);
  });
}

/** The server's own page comes before the kept one, so this page may be of the new build already;
 *  then there is nothing to wait for. */
async function consider(worker: ServiceWorker): Promise<void> {
  if (await isSameBuild(worker)) {
    worker.postMessage({ type: "take over" });
  } else {
    waiting = worker;
    updateWaits.value = true;
  }
}

function isSameBuild(worker: ServiceWorker): Promise<boolean> {
  return new Promise((resolve) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = (event) => resolve(event.data === true);
    worker.postMessage({ type: "same build", value: ownFile() }, [channel.port2]);
  });
}
