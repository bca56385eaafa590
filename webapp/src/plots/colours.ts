// The colours of the plots, from the style sheet, so that dark and light are defined once.
import { signal } from "@preact/signals";

const dark = window.matchMedia("(prefers-color-scheme: dark)");

/** Changes when the phone switches between dark and light: plots are drawn anew. */
export const scheme = signal(dark.matches ? "dark" : "light");
dark.addEventListener("change", () => (scheme.value = dark.matches ? "dark" : "light"));

export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
