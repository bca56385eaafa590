// The screen on show, and going to another.
import { computed, signal } from "@preact/signals";
import { link, parse, type Route } from "../router";

const hash = signal(location.hash);
window.addEventListener("hashchange", () => (hash.value = location.hash));

export const route = computed(() => parse(hash.value));

export type Target = Exclude<Route, { page: "missing" }>;

/** Goes to a screen. `replace` leaves no way back to the present one, which is over. */
export function go(target: Target, replace = false): void {
  if (replace) history.replaceState(null, "", link(target));
  else history.pushState(null, "", link(target));
  hash.value = link(target);
}

window.addEventListener("popstate", () => (hash.value = location.hash));
