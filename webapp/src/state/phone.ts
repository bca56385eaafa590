// This phone, as the robot's control knows it: an identifier that it makes once, and a name.
import { signal } from "@preact/signals";
import { newId } from "../api/ids";
import { t } from "../texts";

const ID = "team.phone";
const NAME = "team.phone-name";

export const phoneId = remembered(ID) ?? remember(ID, newId());

/** What a person called it; else a word and the end of its identifier, to tell two apart. */
export const phoneName = signal(remembered(NAME) ?? t.control.nameless(phoneId.slice(-4)));

export function namePhone(name: string): void {
  phoneName.value = remember(NAME, name);
}

function remembered(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

function remember(key: string, value: string): string {
  try {
    localStorage.setItem(key, value);
  } catch {
    // A browser that keeps nothing is another phone after a reload.
  }
  return value;
}
