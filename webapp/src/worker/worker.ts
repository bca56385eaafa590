// The service worker: keeps the app itself on the phone, so that it opens without the server and
// can say what it knew last. It knows nothing of robots and sends no request of its own to them.
//
// Each build is another worker with its own store. It takes over when the old build's pages are
// gone, or when a person asks for it; never in the middle of somebody's work.
import { answerTo, kept, type Build } from "./shell";

declare const self: ServiceWorkerGlobalScope;
/** Put in by the build. */
declare const BUILD: Build;

const build = BUILD;
const FILES = `team-${build.version}`;
/** What outlives a build: the language that the next one has to bring along. */
const SETTINGS = "team-settings";
const LANGUAGE = "/language";
/** A server in the own network answers at once or not at all. */
const PATIENCE_MS = 3000;

self.addEventListener("install", (event) => event.waitUntil(keepShell()));

self.addEventListener("activate", (event) => event.waitUntil(takeOver()));

self.addEventListener("fetch", (event) => {
  const { request } = event;
  switch (answerTo(request, self.location.origin)) {
    case "page":
      return event.respondWith(page(request));
    case "kept file":
      return event.respondWith(file(request));
    case "not ours":
      return;
  }
});

/** What a page tells: the language in use, that it wants the new build now, or the question whether
 *  it is of this build itself. */
self.addEventListener("message", (event) => {
  const { type, value } = event.data as { type: string; value?: string };
  if (type === "language") event.waitUntil(keepLanguage(value ?? ""));
  if (type === "take over") event.waitUntil(self.skipWaiting());
  if (type === "same build") event.ports[0]?.postMessage(build.shell.includes(value ?? ""));
});

async function keepShell(): Promise<void> {
  const settings = await caches.open(SETTINGS);
  const language = (await (await settings.match(LANGUAGE))?.text()) ?? null;
  await keep(kept(build, language));
}

async function takeOver(): Promise<void> {
  const names = await caches.keys();
  const old = names.filter((name) => name !== FILES && name !== SETTINGS);
  await Promise.all(old.map((name) => caches.delete(name)));
  await self.clients.claim();
}

async function keepLanguage(language: string): Promise<void> {
  const settings = await caches.open(SETTINGS);
  await settings.put(LANGUAGE, new Response(language));
  await keep(kept(build, language));
}

async function keep(paths: readonly string[]): Promise<void> {
  const files = await caches.open(FILES);
  const have = await Promise.all(paths.map((path) => files.match(path)));
  const missing = paths.filter((_, index) => have[index] === undefined);
  // Past the browser's own store, which may hold the page of an older build.
  await files.addAll(missing.map((path) => new Request(path, { cache: "no-cache" })));
}

/** The server's own page if it answers, so that page and server are of one build. */
async function page(request: Request): Promise<Response> {
  const limit = new AbortController();
  const timer = setTimeout(() => limit.abort(), PATIENCE_MS);
  try {
    // By its address, because a navigation itself can't be given a limit.
    return await fetch(request.url, { signal: limit.signal, credentials: "same-origin" });
  } catch {
    const files = await caches.open(FILES);
    return (await files.match("/")) ?? Response.error();
  } finally {
    clearTimeout(timer);
  }
}

async function file(request: Request): Promise<Response> {
  const found = await caches.match(request);
  if (found) return found;
  const fresh = await fetch(request);
  // For a file of another build the server gives the page, which must not be kept as that file.
  if (fresh.ok && fresh.headers.get("Cache-Control")?.includes("immutable")) {
    const files = await caches.open(FILES);
    await files.put(request, fresh.clone());
  }
  return fresh;
}
