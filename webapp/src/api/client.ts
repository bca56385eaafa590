// The one place that calls `fetch`. What may be asked is in endpoints.ts.
import { phoneId, phoneName } from "../state/phone";
import { inOurWords, wordsLoaded } from "../words";
import { fromDocument, unreachable, type Problem, type ProblemDocument } from "./problem";

const BASE = "/api/v1";

/** Where a route is, for links that the browser follows by itself. */
export const address = (path: string): string => BASE + path;

export interface Options {
  body?: unknown;
  file?: Blob;
  /** Goes out even when the page is being closed; for the stop. */
  keepalive?: boolean;
}

type Listener = (problem: Problem) => void;
let onUnauthorised: Listener = () => undefined;

/** Called on each 401, so that the pairing page can come up from anywhere. */
export function whenUnauthorised(listener: Listener): void {
  onUnauthorised = listener;
}

export async function request<T>(method: string, path: string, options: Options = {}): Promise<T> {
  const headers: Record<string, string> = {
    "X-Team-Phone": phoneId,
    // A header holds plain characters only.
    "X-Team-Phone-Name": encodeURIComponent(phoneName.peek()),
  };
  const init: RequestInit = { method, headers, credentials: "same-origin", cache: "no-store" };
  if (options.keepalive) init.keepalive = true;
  if (options.file) {
    init.body = options.file;
    headers["Content-Type"] = options.file.type || "application/octet-stream";
  } else if (options.body !== undefined) {
    init.body = JSON.stringify(options.body);
    headers["Content-Type"] = "application/json";
  }
  let response: Response;
  try {
    response = await fetch(BASE + path, init);
  } catch {
    throw unreachable();
  }
  if (response.ok) return (await readJson(response)) as T;
  const problem = fromDocument(
    ((await readJson(response)) ?? {}) as ProblemDocument,
    response.status,
  );
  if (response.status === 401) onUnauthorised(problem);
  throw problem;
}

/** The answer's JSON; null when there is none (204, or a proxy's own error page). */
async function readJson(response: Response): Promise<unknown> {
  const text = await response.text();
  if (text === "") return null;
  await wordsLoaded;
  try {
    return inOurWords(JSON.parse(text));
  } catch {
    return null;
  }
}
