// Every language says everything, and says it itself. What the compiler cannot see: groups whose
// keys are any words, texts that are empty, and English that was left over.
import { describe, expect, it } from "vitest";
import { LANGUAGES } from ".";
import { de } from "./de";
import { en } from "./en";
import { fr } from "./fr";
import { it as italian } from "./it";

const OTHERS: Record<string, unknown> = { de, fr, it: italian };

/** Words that are the same in both languages; everything else that is the same was forgotten. */
const EVERYWHERE = ["TEAM", "min", "Android", "iPhone", "iPhone iPad"];
const SAME: Record<string, readonly string[]> = {
  de: [
    "Code",
    "Computer",
    "live",
    "Name",
    "Offline",
    "Pause",
    "Position",
    "Start",
    "Training",
    "Version",
  ],
  fr: ["Code", "Messages", "Pause", "Position", "Robot", "Robots", "Stop", "Version"],
  it: ["Computer", "Robot", "Stop"],
};

/** Values by which one sees where they end up. */
const VALUES = ["⟨0⟩", "⟨1⟩", "⟨2⟩", "⟨3⟩", "⟨4⟩", "⟨5⟩"];

type Leaf = { path: string; text: string };

/** All texts by their place; those made by functions with values that can be found again. */
function leaves(texts: unknown, path = "", values: readonly unknown[] = VALUES): Leaf[] {
  if (typeof texts === "string") return [{ path, text: texts }];
  if (typeof texts === "function") return [{ path, text: String(texts(...values)) }];
  return Object.entries(texts as object).flatMap(([key, value]) =>
    leaves(value, path === "" ? key : `${path}.${key}`, values),
  );
}

const without = (text: string) =>
  text
    .replace(/⟨\d⟩/g, "")
    .replace(/[^\p{L}]+/gu, " ")
    .trim();
const english = new Map(leaves(en).map(({ path, text }) => [path, text]));

describe.each(Object.entries(OTHERS))("%s", (language, texts) => {
  const all = leaves(texts);

  it("has the same texts as English, no more and no fewer", () => {
    expect(all.map(({ path }) => path).sort()).toEqual([...english.keys()].sort());
  });

  it("leaves nothing empty", () => {
    expect(all.filter(({ text }) => text.trim() === "")).toEqual([]);
  });

  it("shows every value that English shows", () => {
    const values = (text: string) => VALUES.filter((value) => text.includes(value));
    for (const { path, text } of all) {
      expect(values(text), `${path}: ${text}`).toEqual(values(english.get(path) ?? ""));
    }
  });

  it("has no English left over", () => {
    const same = all.filter(({ path, text }) => {
      const words = without(text);
      return /\p{L}{3}/u.test(words) && words === without(english.get(path) ?? "");
    });
    const allowed = [...EVERYWHERE, ...(SAME[language] ?? [])];
    const forgotten = same.filter(({ text }) => !allowed.includes(without(text)));
    expect(forgotten).toEqual([]);
  });

  it("speaks of one, of none and of many", () => {
    for (const count of [0, 1, 2, 5]) {
      for (const { path, text } of leaves(texts, "", Array(6).fill(count))) {
        expect(text.trim(), path).not.toMatch(/^$|undefined|NaN|\[object/);
      }
    }
  });
});

it("offers every language that there is, by its own name", () => {
  expect(LANGUAGES.map((one) => one.code)).toEqual(["en", ...Object.keys(OTHERS)]);
  expect(new Set(LANGUAGES.map((one) => one.name)).size).toBe(LANGUAGES.length);
});
