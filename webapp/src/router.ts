// Which screen the address shows. Everything is in the fragment, so the server knows one page.

export type Route =
  | { page: "teach" }
  | { page: "new-task" }
  | { page: "task"; task: string }
  | { page: "more"; task: string }
  | { page: "record"; task: string }
  | { page: "take"; task: string; take: string }
  | { page: "model"; task: string; model: string }
  | { page: "robots" }
  | { page: "dashboard" }
  | { page: "language" }
  | { page: "join" }
  | { page: "run" }
  | { page: "setup"; task: string }
  | { page: "preview"; task: string }
  | { page: "motion"; task: string; motion: string }
  | { page: "questions"; task: string; motion: string }
  | { page: "positions"; task: string }
  | { page: "missing" };

export function parse(hash: string): Route {
  const parts = hash
    .replace(/^#?\/?/, "")
    .split("/")
    .filter(Boolean)
    .map(decode);
  const [section = "teach", task, place, id, further] = parts;
  if (section === "teach") {
    if (task === undefined) return { page: "teach" };
    if (task === "new" && place === undefined) return { page: "new-task" };
    if (place === undefined) return { page: "task", task };
    if (place === "more") return { page: "more", task };
    if (place === "record") return { page: "record", task };
    if (place === "takes" && id !== undefined) return { page: "take", task, take: id };
    if (place === "models" && id !== undefined) return { page: "model", task, model: id };
  }
  if (section === "robots" && task === undefined) return { page: "robots" };
  if (section === "dashboard" && task === undefined) return { page: "dashboard" };
  if (section === "language" && task === undefined) return { page: "language" };
  if (section === "join") return { page: "join" };
  if (section === "run") {
    if (task === undefined) return { page: "run" };
    if (place === undefined) return { page: "setup", task };
    if (place === "preview") return { page: "preview", task };
    if (place === "positions") return { page: "positions", task };
    if (place === "motions" && id !== undefined) {
      return { page: further === "questions" ? "questions" : "motion", task, motion: id };
    }
  }
  return { page: "missing" };
}

export function link(route: Exclude<Route, { page: "missing" }>): string {
  switch (route.page) {
    case "teach":
      return "#/teach";
    case "new-task":
      return "#/teach/new";
    case "task":
      return `#/teach/${encodeURIComponent(route.task)}`;
    case "more":
    case "record":
      return `#/teach/${encodeURIComponent(route.task)}/${route.page}`;
    case "take":
      return `#/teach/${encodeURIComponent(route.task)}/takes/${encodeURIComponent(route.take)}`;
    case "model":
      return `#/teach/${encodeURIComponent(route.task)}/models/${encodeURIComponent(route.model)}`;
    case "robots":
      return "#/robots";
    case "dashboard":
      return "#/dashboard";
    case "language":
      return "#/language";
    case "join":
      return "#/join";
    case "run":
      return "#/run";
    case "setup":
      return `#/run/${encodeURIComponent(route.task)}`;
    case "preview":
    case "positions":
      return `#/run/${encodeURIComponent(route.task)}/${route.page}`;
    case "motion":
      return `#/run/${encodeURIComponent(route.task)}/motions/${encodeURIComponent(route.motion)}`;
    case "questions":
      return `${link({ ...route, page: "motion" })}/questions`;
  }
}

/** The pairing code of an address like `…/#pair=123456` (what the QR code leads to). */
export function pairingCode(hash: string): string | null {
  return /^#pair=([^&/]+)$/.exec(hash)?.[1] ?? null;
}

function decode(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}
