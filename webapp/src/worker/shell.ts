// Which requests the service worker answers, and from where. Pure; the events are in worker.ts.

/** What the build found out about its own files; the build script puts it in. */
export interface Build {
  /** Another one with every change of a file. */
  version: string;
  /** What the app needs to start, whatever the language. */
  shell: readonly string[];
  /** What it needs besides in each other language. */
  languages: Readonly<Record<string, readonly string[]>>;
}

/** What is kept beforehand: the shell, and the words of the language in use. */
export function kept(build: Build, language: string | null): string[] {
  return [...build.shell, ...(build.languages[language ?? ""] ?? [])];
}

export type Answer =
  /** The browser asks the server as if there were no worker. */
  | "not ours"
  /** The page: from the server if it answers, else the one that was kept. */
  | "page"
  /** A file whose name holds its content's hash: the kept one is the right one. */
  | "kept file";

interface Asked {
  method: string;
  url: string;
  mode: string;
}

/** Only pages and files are ever answered from here. Whatever the interface is asked, reading or
 *  commanding, goes to the server at once or fails at once: nothing is kept for later. */
export function answerTo({ method, url, mode }: Asked, origin: string): Answer {
  const { origin: where, pathname } = new URL(url);
  if (method !== "GET" || where !== origin) return "not ours";
  if (pathname.startsWith("/assets/")) return "kept file";
  return mode === "navigate" && (pathname === "/" || pathname === "/index.html")
    ? "page"
    : "not ours";
}
