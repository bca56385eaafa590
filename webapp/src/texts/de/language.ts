// German words around the choice of the language. The languages' own names stand in texts/index.ts.
import type { Texts } from "..";

export const language: Texts["language"] = {
  link: (name: string) => `Sprache: ${name}`,
  explain: "Die Seite wird in der Sprache neu geladen, die Sie drücken.",
};
