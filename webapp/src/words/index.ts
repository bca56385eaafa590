// The server speaks English; what it says is said here in the phone's language (ADR 0032). The
// words of the app itself are in texts/.
import { language, locale, typeset } from "../texts";
import { setAll } from "../texts/typography";
import { sayAnswer } from "./answers";
import { Catalogue } from "./catalogue";

const LOADERS: Record<string, () => Promise<Record<string, string>>> = {
  de: () => import("./de").then((words) => words.de),
  fr: () => import("./fr").then((words) => words.fr),
  it: () => import("./it").then((words) => words.it),
};

let catalogue: Catalogue | null = null;

/** Settles when the words are here. The app is drawn meanwhile; its first answer waits for them,
 *  and the live socket is opened after that. */
export const wordsLoaded: Promise<void> = load();

/** Words that cannot be fetched must not keep anybody from the robot: English says it too. */
async function load(): Promise<void> {
  try {
    const entries = await LOADERS[language]?.();
    if (!entries) return;
    const decimalSign = new Intl.NumberFormat(locale).format(1.5).charAt(1);
    catalogue = new Catalogue(setAll(entries, typeset), decimalSign);
  } catch {
    // Then everything else is still there.
  }
}

/** An answer or a message of the server, with its words in the phone's language. */
export function inOurWords<T>(answer: T): T {
  if (catalogue) sayAnswer(answer, catalogue);
  return answer;
}
