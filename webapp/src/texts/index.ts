// The words in use. Each language is a folder of the same shape as en/, loaded only when it is
// wanted; a change of language loads the page anew, so that no sentence of the old one is left.
import { en } from "./en";
import { pickLanguage, rememberedLanguage, rememberLanguage, type Language } from "./language";

export type Texts = typeof en;

const LOADERS: Record<string, () => Promise<Texts>> = {
  en: () => Promise.resolve(en),
};

export const LANGUAGES: readonly Language[] = [{ code: "en", name: "English" }];

export const language = pickLanguage(
  rememberedLanguage(),
  navigator.languages ?? [],
  LANGUAGES.map((one) => one.code),
);

export const t: Texts = await (LOADERS[language] ?? LOADERS["en"]!)();

document.documentElement.lang = language;

/** A person chooses another language. */
export function chooseLanguage(code: string): void {
  rememberLanguage(code);
  location.reload();
}
