// Says an English sentence of the server in another language. It is found by its template; what
// stands in the template's gaps is said in that language too where it is known, and else stays.
import { bare, sentencesOf, Template, wordsOf } from "./template";

/** Gaps in which names stand that people gave: one word alone is never taken for ours. */
const NAMES = new Set(["asked", "name", "of", "path", "robot", "url", "user"]);

/** Sentences that were said before are found at once; the robot says the same many times. */
const REMEMBERED = 500;

export class Catalogue {
  private readonly exact = new Map<string, string>();
  /** By a word that must be in the text; those without one under "". Best first. */
  private readonly templates = new Map<string, Template[]>();
  private said = new Map<string, string>();

  constructor(
    entries: Readonly<Record<string, string>>,
    private readonly decimalSign: string,
  ) {
    for (const [english, translation] of Object.entries(entries)) {
      this.add(english, translation);
      // The same is said of a recording that has no name yet.
      if (english.startsWith("{name}: ")) {
        this.add(english.slice(8), translation.replace(/^\{name\}\s?: /, ""));
      }
    }
    for (const list of this.templates.values()) list.sort((a, b) => b.rank - a.rank);
  }

  private add(english: string, translation: string): void {
    if (english.includes("{")) {
      const template = new Template(english, bareEnd(translation));
      const list = this.templates.get(template.word) ?? [];
      this.templates.set(template.word, list.concat(template));
      return;
    }
    // Of the same words as a sentence and as a part of one, the part has the right first letter.
    const key = bare(english);
    if (key === english || !this.exact.has(key)) this.exact.set(key, bareEnd(translation));
  }

  /** The text in this language; what nobody translated stays as it is. */
  translate(text: string): string {
    const before = this.said.get(text);
    if (before !== undefined) return before;
    const now =
      this.known(text) ??
      sentencesOf(text)
        .map((sentence) => this.known(sentence) ?? sentence)
        .join(" ");
    if (this.said.size >= REMEMBERED) this.said = new Map();
    this.said.set(text, now);
    return now;
  }

  /** Null when it is not one of our sentences, nor a row or a list of them. */
  private known(text: string): string | null {
    const sentences = sentencesOf(text);
    return (
      this.whole(text, isOne) ??
      this.row(sentences) ??
      this.whole(text, () => true) ??
      this.list(text, "; ") ??
      this.list(text, ", ")
    );
  }

  /** One sentence. `may` says what may stand in a gap. */
  private whole(text: string, may: (value: string) => boolean): string | null {
    const key = bare(text);
    const exact = this.exact.get(key);
    if (exact !== undefined) return dressed(exact, text);
    for (const template of this.candidates(key)) {
      const found = template.fit(key);
      if (!found || ![...found.values()].every(may)) continue;
      const filled = this.gaps(found, template.weak);
      if (filled) return dressed(template.fill(filled), text);
    }
    return null;
  }

  private candidates(text: string): Template[] {
    const words = new Set(["", ...wordsOf(text)]);
    const lists = [...words].flatMap((word) => this.templates.get(word) ?? []);
    return lists.sort((a, b) => b.rank - a.rank);
  }

  private gaps(found: Map<string, string>, all: boolean): Map<string, string> | null {
    const filled = new Map<string, string>();
    for (const [name, value] of found) {
      const said = this.gap(name, value);
      if (said === null && all) return null;
      filled.set(name, said ?? value);
    }
    return filled;
  }

  private gap(name: string, value: string): string | null {
    if (/^-?\d+(\.\d+)?$/.test(value)) return value.replace(".", this.decimalSign);
    if (NAMES.has(name) && !value.includes(" ")) return null;
    return this.known(value);
  }

  /** Several sentences, all of them known; as few as possible taken for one. */
  private row(sentences: string[]): string | null {
    for (let end = sentences.length - 1; end > 0; end--) {
      const first = this.whole(sentences.slice(0, end).join(" "), isOne);
      const rest = first === null ? null : this.known(sentences.slice(end).join(" "));
      if (first !== null && rest !== null) return `${first} ${rest}`;
    }
    return null;
  }

  private list(text: string, sign: string): string | null {
    const parts = text.split(sign);
    if (parts.length < 2) return null;
    const said = parts.map((part) => this.gap("", part));
    return said.every((part) => part !== null) ? said.join(sign) : null;
  }
}

function isOne(text: string): boolean {
  return sentencesOf(text).length === 1;
}

function bareEnd(text: string): string {
  return text.endsWith(".") ? text.slice(0, -1) : text;
}

/** With the capital letter and the full stop of the English text. */
function dressed(said: string, english: string): string {
  const first = english.charAt(0);
  const capital = first !== first.toLowerCase();
  const begun = capital ? said.charAt(0).toUpperCase() + said.slice(1) : said;
  return english.endsWith(".") && !/[.!?]$/.test(begun) ? `${begun}.` : begun;
}
