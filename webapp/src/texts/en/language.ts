// English words around the choice of the language. The languages' own names stand in texts/index.ts.
export const language = {
  link: (name: string) => `Language: ${name}`,
  explain: "The page is loaded again in the language that you press.",
};
