// Which members of the server's answers and live messages carry words for people, and how these
// are said in the phone's language. Names that people gave are never looked up.
import type { Catalogue } from "./catalogue";

/** Members that hold a sentence, or a list of sentences. */
const SENTENCES = new Set([
  "advice",
  "detail",
  "message",
  "note",
  "notes",
  "problem",
  "reason",
  "summary",
  "title",
  "verdict",
  "warnings",
  "words",
]);

/** What the server calls a signal, a robot and a phone that nobody gave a name: by a member of
 *  theirs, or by the member that holds them. */
const CALLED: [of: string, members: string[]][] = [
  ["off", ["label", "on", "off"]],
  ["egm", ["name"]],
];
const PHONES = ["phone", "asked_by"];

/** Of a member's object with this in it, everything was written by a person. */
const OPINION = "worked";

/** Changes the answer where it stands: it has just been read and nobody else has it. */
export function sayAnswer(answer: unknown, catalogue: Catalogue): void {
  if (Array.isArray(answer)) {
    // Curves are long, and there are no words in them.
    if (typeof answer[0] !== "object" || holdsNumbers(answer[0])) return;
    for (const item of answer) sayAnswer(item, catalogue);
    return;
  }
  if (typeof answer !== "object" || answer === null || OPINION in answer) return;
  const members = answer as Record<string, unknown>;
  for (const [name, value] of Object.entries(members)) {
    if (!SENTENCES.has(name)) sayAnswer(value, catalogue);
    else members[name] = said(value, catalogue);
  }
  for (const phone of PHONES.map((name) => members[name]).filter(isPhone)) {
    phone["name"] = said(phone["name"], catalogue);
  }
  for (const [of, called] of CALLED) {
    if (of in members) {
      for (const name of called) members[name] = said(members[name], catalogue, true);
    }
  }
}

/** As answers hold them: an identifier and a name. */
function isPhone(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && "name" in value;
}

function said(value: unknown, catalogue: Catalogue, anyWord = false): unknown {
  if (typeof value === "string") {
    // A single small word such as "differs" is a code for programs.
    return anyWord || /[ \p{Lu}]/u.test(value) ? catalogue.translate(value) : value;
  }
  if (Array.isArray(value)) return value.map((item) => said(item, catalogue));
  sayAnswer(value, catalogue);
  return value;
}

function holdsNumbers(item: unknown): boolean {
  return Array.isArray(item) && typeof item[0] === "number";
}
