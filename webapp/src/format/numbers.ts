// Numbers as people of this phone's country read and type them.
import { locale, t } from "../texts";

/** Making one of these is slow, and the same few are wanted many times a second. */
const FORMS = new Map<string, Intl.NumberFormat>();

function written(value: number, digits: Intl.NumberFormatOptions): string {
  const key = JSON.stringify(digits);
  const form = FORMS.get(key) ?? new Intl.NumberFormat(locale, { useGrouping: false, ...digits });
  FORMS.set(key, form);
  return form.format(value).replace("-", "−");
}

/** A number with a fixed count of decimals, and a proper minus sign. */
export function fixed(value: number, decimals: number): string {
  const digits = { minimumFractionDigits: decimals, maximumFractionDigits: decimals };
  return written(Number(value.toFixed(decimals)) === 0 ? 0 : value, digits);
}

/** A number with so many decimals at the most. */
export function atMost(value: number, decimals: number): string {
  const digits = { maximumFractionDigits: decimals };
  return written(Number(value.toFixed(decimals)) === 0 ? 0 : value, digits);
}

/** A number of unknown size, by its first digits that are not nought. */
export function significant(value: number, digits: number): string {
  return written(value, { minimumSignificantDigits: digits, maximumSignificantDigits: digits });
}

export function degrees(value: number, decimals = 1): string {
  return t.units.degrees(fixed(value, decimals));
}

/** A small error: one that rounds to nothing is said to be small, not to be nought. */
export function errorDegrees(value: number, decimals: number): string {
  const smallest = 10 ** -decimals;
  return value < smallest / 2
    ? t.units.below(degrees(smallest, decimals))
    : degrees(value, decimals);
}

export function millimetres(value: number): string {
  return t.units.millimetres(fixed(value, 1));
}

/** Below a minute "7.3 s", from then on "1:05 min". */
export function duration(seconds: number): string {
  if (seconds < 59.95) return t.units.seconds(fixed(seconds, 1));
  const whole = Math.round(seconds);
  return t.units.minutes(Math.floor(whole / 60), String(whole % 60).padStart(2, "0"));
}

/** How old something is, in the coarsest words that are still honest. */
export function age(milliseconds: number): string {
  const seconds = milliseconds / 1000;
  if (seconds < 60) return t.units.seconds(fixed(Math.floor(seconds), 0));
  return t.units.minutes(
    Math.floor(seconds / 60),
    String(Math.floor(seconds) % 60).padStart(2, "0"),
  );
}

export function percent(fraction: number): string {
  return t.units.percent(fixed(100 * fraction, 0));
}

/** A typed number; comma or point before the decimals. Null when it is not one. */
export function parseDecimal(text: string): number | null {
  const plain = text.trim().replace("−", "-").replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}
