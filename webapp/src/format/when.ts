// Moments as people read them: day and time of day on this phone's clock.
import { locale } from "../texts";

const MOMENT = new Intl.DateTimeFormat(locale, {
  day: "numeric",
  month: "short",
  hour: "2-digit",
  minute: "2-digit",
  hourCycle: "h23",
});
const DAY = new Intl.DateTimeFormat(locale, { day: "numeric", month: "short", timeZone: "UTC" });
const MONTH = new Intl.DateTimeFormat(locale, {
  month: "long",
  year: "numeric",
  timeZone: "UTC",
});

/** A moment of the server, as "24 Nov, 19:52" in the order of the phone's country. */
export function moment(iso: string): string {
  return MOMENT.format(new Date(iso));
}

/** A calendar day without a time: "24 Nov". */
export function day(date: string): string {
  return DAY.format(new Date(`${date}T00:00:00Z`));
}

/** The month of a calendar day: "November 2026". */
export function month(date: string): string {
  return MONTH.format(new Date(`${date}T00:00:00Z`));
}
