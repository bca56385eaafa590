// Which language this phone reads: what a person chose, else the phone's own, else English.

const REMEMBERED = "team.language";

export interface Language {
  /** As in BCP 47; also sets the form of numbers and dates. */
  code: string;
  /** In its own words: nobody has to read another language to find theirs. */
  name: string;
}

/** The first of the phone's languages that there is, by its main part: "de-CH" is "de". */
export function pickLanguage(
  chosen: string | null,
  preferred: readonly string[],
  available: readonly string[],
): string {
  const wanted = [chosen ?? "", ...preferred].map((tag) => tag.toLowerCase().split("-")[0] ?? "");
  return wanted.find((code) => available.includes(code)) ?? available[0] ?? "en";
}

/** The language with the country of this phone, where the phone says one: numbers differ by it. */
export function regionalForm(language: string, preferred: readonly string[]): string {
  return preferred.find((tag) => tag.toLowerCase().split("-")[0] === language) ?? language;
}

export function rememberedLanguage(): string | null {
  try {
    return localStorage.getItem(REMEMBERED);
  } catch {
    return null;
  }
}

export function rememberLanguage(code: string): void {
  try {
    localStorage.setItem(REMEMBERED, code);
  } catch {
    // A browser that keeps nothing goes on in the phone's own language.
  }
}
