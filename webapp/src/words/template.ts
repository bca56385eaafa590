// One sentence of the catalogue with gaps in it: what fits it, and how a fitting one is said.
// Gaps are written as in the server's sources: {}, {0}, {name}, {value_deg:.1}.

/** A gap is called by its name or, like in Rust, by the how-manieth nameless one it is. */
export function gapsOf(template: string): string[] {
  let nameless = 0;
  return [...template.matchAll(GAP)].map(([, inside]) => {
    const name = (inside ?? "").split(":")[0]!;
    return name === "" ? String(nameless++) : name;
  });
}

const GAP = /\{([^{}]*)\}/g;

/** With a small letter at the beginning and no full stop at the end, as sentences stand inside
 *  others. */
export function bare(text: string): string {
  const open = text.endsWith(".") ? text.slice(0, -1) : text;
  return open.charAt(0).toLowerCase() + open.slice(1);
}

/** Sentences that stand one after the other. */
export function sentencesOf(text: string): string[] {
  const sentences: string[] = [];
  let begins = 0;
  for (const end of text.matchAll(/[.!?] (?=\p{Lu})/gu)) {
    sentences.push(text.slice(begins, end.index + 1));
    begins = end.index + 2;
  }
  sentences.push(text.slice(begins));
  return sentences;
}

export class Template {
  /** A word that is in every text that fits; empty when there is none. */
  readonly word: string;
  /** So little of it is fixed that nearly anything fits: then its gaps must be known words. */
  readonly weak: boolean;
  /** The higher, the earlier it is tried: what begins with words before what begins with a gap,
   *  since the outer sentence begins first; then the one with more words. */
  readonly rank: number;
  private readonly gaps: string[];
  private readonly translationGaps: string[];
  private readonly form: RegExp;

  constructor(
    english: string,
    private readonly translation: string,
  ) {
    const parts = bare(english).split(/\{[^{}]*\}/);
    const specs = [...english.matchAll(GAP)].map(([, inside]) => inside ?? "");
    const fixed = parts.join("");
    const letters = fixed.replace(/[^\p{L}]/gu, "").length;
    this.gaps = gapsOf(english);
    this.translationGaps = gapsOf(translation);
    this.word = longestWord(parts);
    this.weak = letters <= 5 && !/[("]/.test(fixed);
    this.rank = letters + (this.weak ? 0 : 1000) + (parts[0] === "" ? 0 : 10_000);
    const pattern = parts
      .map((part, at) => escaped(part) + (at < specs.length ? gapForm(specs[at]!) : ""))
      .join("");
    this.form = new RegExp(`^${pattern}$`, "su");
  }

  /** What stands in the gaps of a bare text; null when it does not fit. */
  fit(text: string): Map<string, string> | null {
    const match = this.form.exec(text);
    return match && new Map(this.gaps.map((gap, at) => [gap, match[at + 1] ?? ""]));
  }

  fill(values: ReadonlyMap<string, string>): string {
    let at = 0;
    return this.translation.replace(GAP, () => values.get(this.translationGaps[at++]!) ?? "");
  }
}

const NUMBER = String.raw`(-?\d+(?:\.\d+)?|-?inf|NaN)`;

/** A name has no comma: else a list of things with names would fit as one name. */
function gapForm(inside: string): string {
  if (/:\.\d/.test(inside)) return NUMBER;
  return inside === "name" ? "([^,]+?)" : "(.+?)";
}

/** Of the words that do not touch a gap, where more letters could belong to them. */
function longestWord(parts: string[]): string {
  const whole = parts.map((part, at) => {
    const begun = at === 0 ? part : part.replace(/^[\p{L}\p{N}_]+/u, "");
    return at === parts.length - 1 ? begun : begun.replace(/[\p{L}\p{N}_]+$/u, "");
  });
  return wordsOf(whole.join(" ")).reduce((best, w) => (w.length > best.length ? w : best), "");
}

export function wordsOf(text: string): string[] {
  return text.toLowerCase().match(/[\p{L}\p{N}_]+/gu) ?? [];
}

function escaped(text: string): string {
  return text.replace(/[.*+?^${}()|[\]\\/]/g, "\\$&");
}
