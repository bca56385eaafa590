import { expect, test } from "vitest";
import { setAll, typesetter } from "./typography";

test("French signs are not torn from their word", () => {
  const set = typesetter("fr-CH");
  expect(set("Garder ?")).toBe("Garder\u202f?");
  expect(set("Exemples gardés : 2 sur 3")).toBe("Exemples gardés\u00a0: 2 sur 3");
  expect(set("Attention ! Oui ; non")).toBe("Attention\u202f! Oui\u202f; non");
  expect(set("1:05 min")).toBe("1:05 min");
});

test("Swiss phones read ss, those of Germany ß", () => {
  expect(typesetter("de-CH")("Größe")).toBe("Grösse");
  expect(typesetter("de-DE")("Größe")).toBe("Größe");
  expect(typesetter("de")("Größe")).toBe("Größe");
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
  expect(setAll(texts, typesetter("it"))).toBe(texts);
});
