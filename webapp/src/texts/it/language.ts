// Italian words around the choice of the language. The languages' own names stand in texts/index.ts.
import type { Texts } from "..";

export const language: Texts["language"] = {
  link: (name: string) => `Lingua: ${name}`,
  explain: "La pagina viene ricaricata nella lingua scelta.",
};
