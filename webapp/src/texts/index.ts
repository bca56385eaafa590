// The words in use. Each language is a folder of the same shape as en/, loaded only when it is
// wanted; a change of language loads the page anew, so that no sentence of the old one is left.
import { en } from "./en";
import {
  pickLanguage,
  regionalForm,
  rememberedLanguage,
  rememberLanguage,
  type Language,
} from "./language";
import { setAll, typesetter } from "./typography";

export type Texts = typeof en;

const LOADERS: Record<string, () => Promise<Texts>> = {
  en: () => Promise.resolve(en),
  de: () => import("./de").then((words) => words.de),
  fr: () => import("./fr").then((words) => words.fr),
  it: () => import("./it").then((words) => words.it),
};

export const LANGUAGES: readonly Language[] = [
  { code: "en", name: "English" },
  { code: "de", name: "Deutsch" },
  { code: "fr", name: "Français" },
  { code: "it", name: "Italiano" },
];

const wanted = pickLanguage(
  rememberedLanguage(),
  navigator.languages ?? [],
  LANGUAGES.map((one) => one.code),
);

/** Words that cannot be fetched must not keep anybody from the robot: English is always there. */
const [loadedLanguage, words] = await load(wanted);

export const language = loadedLanguage;

/** The language as this phone's country writes it: "de-CH" has another decimal sign than "de". */
export const locale = regionalForm(language, navigator.languages ?? []);

/** Sets a text as this language's readers expect; what `t` has is set already. */
export const typeset = typesetter(locale);

export const t: Texts = setAll(words, typeset);

document.documentElement.lang = language;

async function load(code: string): Promise<[string, Texts]> {
  try {
    return [code, await LOADERS[code]!()];
  } catch {
    return ["en", en];
  }
}

/** A person chooses another language. */
export function chooseLanguage(code: string): void {
  rememberLanguage(code);
  location.reload();
}
