// French words around the choice of the language. The languages' own names stand in texts/index.ts.
import type { Texts } from "..";

export const language: Texts["language"] = {
  link: (name: string) => `Langue : ${name}`,
  explain: "La page est rechargée dans la langue choisie.",
};
