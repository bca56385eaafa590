// What print has and keyboards have not: done in one place, so that texts are written plainly.

type Setter = (text: string) => string;

const plain: Setter = (text) => text;

/** The sign that stands for a vowel left out: "l'axe", "un po' diverso". */
const apostrophes: Setter = (text) => text.replace(/(\p{L})'/gu, "$1’");

/** French has spaces where no line may end: before high signs, narrow but for ":", and in quotes. */
const french: Setter = (text) =>
  apostrophes(text)
    .replace(/ ([;?!])/g, "\u202f$1")
    .replace(/ (:)(?=\s|$)/g, "\u00a0$1")
    .replace(/« /g, "«\u00a0")
    .replace(/ »/g, "\u00a0»");

const swissGerman: Setter = (text) =>
  text.replaceAll("ß", "ss").replaceAll("„", "«").replaceAll("“", "»");

export function typesetter(locale: string): Setter {
  const [language, country] = locale.toLowerCase().split("-");
  if (language === "fr") return french;
  if (language === "it") return apostrophes;
  if (language === "de" && (country === "ch" || country === "li")) return swissGerman;
  return plain;
}

/** The same texts with each of them set, also those that are made by a function. */
export function setAll<T>(texts: T, set: Setter): T {
  return set === plain ? texts : (setOne(texts, set) as T);
}

function setOne(text: unknown, set: Setter): unknown {
  if (typeof text === "string") return set(text);
  if (typeof text === "function") return (...values: unknown[]) => setOne(text(...values), set);
  if (Array.isArray(text)) return text.map((one) => setOne(one, set));
  if (typeof text !== "object" || text === null) return text;
  return Object.fromEntries(Object.entries(text).map(([key, value]) => [key, setOne(value, set)]));
}
