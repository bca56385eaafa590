// That every language has an entry for every sentence is tested against the server's sources
// (tests/end_to_end/tidy/words.rs); here, that the languages agree with each other.
import { describe, expect, it } from "vitest";
import { LANGUAGES as OF_THE_APP } from "../texts";
import { Catalogue } from "./catalogue";
import { de } from "./de";
import { fr } from "./fr";
import { it as italian } from "./it";
import { gapsOf } from "./template";

const LANGUAGES: Record<string, Record<string, string>> = { de, fr, it: italian };

/** An English text that fits the template. */
const filled = (english: string) =>
  english.replace(/\{[^{}]*\}/g, (gap) => (/:\.\d/.test(gap) ? "12.5" : "7"));

for (const [code, entries] of Object.entries(LANGUAGES)) {
  describe(`the words in ${code}`, () => {
    it("are about the same sentences as in German", () => {
      expect(Object.keys(entries).sort()).toEqual(Object.keys(de).sort());
    });

    it("have the gaps of the English sentence, in whatever order", () => {
      const wrong = Object.entries(entries).filter(
        ([english, said]) => gapsOf(english).sort().join() !== gapsOf(said).sort().join(),
      );
      expect(wrong).toEqual([]);
    });

    it("end and begin as the English sentence does", () => {
      const stop = (text: string) => /[.!?]$/.test(text);
      const wrong = Object.entries(entries).filter(
        ([english, said]) => said.trim() !== said || said === "" || stop(english) !== stop(said),
      );
      expect(wrong).toEqual([]);
    });

    it("are found for every sentence", () => {
      const catalogue = new Catalogue(entries, ",");
      const lost = Object.keys(entries).filter((english) => {
        const text = filled(english);
        return catalogue.translate(text) === text && entries[english] !== english;
      });
      expect(lost).toEqual([]);
    });
  });
}

it("there are words in every language of the app", () => {
  const codes = OF_THE_APP.map((one) => one.code).filter((code) => code !== "en");
  expect(Object.keys(LANGUAGES).sort()).toEqual(codes.sort());
});

it("they are written plainly: texts/typography.ts sets them", () => {
  const set = Object.values(LANGUAGES)
    .flatMap(Object.values)
    .filter((said) => /[\u00a0\u202f’]/.test(said));
  expect(set).toEqual([]);
});
