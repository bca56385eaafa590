import { expect, test } from "vitest";
import { setAll, typesetter } from "./typography";

test("French signs are not torn from their word", () => {
  const set = typesetter("fr-CH");
  expect(set("Garder ?")).toBe("Garder\u202f?");
  expect(set("Exemples gardés : 2 sur 3")).toBe("Exemples gardés\u00a0: 2 sur 3");
  expect(set("Attention ! Oui ; non")).toBe("Attention\u202f! Oui\u202f; non");
  expect(set("l'axe s'arrête")).toBe("l’axe s’arrête");
  expect(set("« Fin »")).toBe("«\u00a0Fin\u00a0»");
  expect(set("1:05 min")).toBe("1:05 min");
});

test("Swiss phones read ss and their quotes, those of Germany ß and theirs", () => {
  expect(typesetter("de-CH")("„Ende“ löschen")).toBe("«Ende» löschen");
  expect(typesetter("de-DE")("„Ende“ löschen")).toBe("„Ende“ löschen");
  expect(typesetter("de-CH")("Größe")).toBe("Grösse");
  expect(typesetter("de-DE")("Größe")).toBe("Größe");
  expect(typesetter("de")("Größe")).toBe("Größe");
});

test("an Italian apostrophe is one, also at the end of a word", () => {
  expect(typesetter("it-CH")("un po' diverso, all'inizio")).toBe("un po’ diverso, all’inizio");
});

test("texts are set wherever they are: in lists, groups and functions", () => {
  const texts = {
    ask: "Garder ?",
    steps: ["Un :", "deux"],
    group: { of: (one: string, many: number) => `${one} : ${many}` },
  };
  const set = setAll(texts, typesetter("fr"));
  expect(set.ask).toBe("Garder\u202f?");
  expect(set.steps).toEqual(["Un\u00a0:", "deux"]);
  expect(set.group.of("Pince", 3)).toBe("Pince\u00a0: 3");
  expect(setAll(texts, typesetter("en"))).toBe(texts);
});
