// How a phone comes in over HTTPS: the code it was given, the address it goes on to, and whether it
// has this cell's certificate yet.
import { signal } from "@preact/signals";
import { go } from "./navigation";

const CODE = "team.code";
const CERTIFICATE = "/team-cell.crt";

export const certificateFile = CERTIFICATE;

/** Whether this phone trusts the cell; null until it was tried. */
export const trusted = signal<boolean | null>(null);

/** Keeps the code of an address like `…/#/join/04711815` for this tab: on the way through the
 *  phone's settings the page may be loaded anew. It is taken out of the address and the history. */
export function takeCode(): void {
  const code = /^#\/join\/(\d+)$/.exec(location.hash)?.[1];
  if (code === undefined) return;
  try {
    sessionStorage.setItem(CODE, code);
  } catch {
    // It has to be typed then.
  }
  go({ page: "join" }, true);
}

function code(): string | null {
  try {
    return sessionStorage.getItem(CODE);
  } catch {
    return null;
  }
}

/** The app's address with the code in it, which pairs without typing. */
export function onwards(secured: boolean): string {
  const known = code();
  const base = secured ? securedOrigin() : location.origin;
  return known === null ? `${base}/#/teach` : `${base}/#pair=${known}`;
}

/** HTTPS is at the same port, also at one that a browser leaves out. */
function securedOrigin(): string {
  const port = location.port || (location.protocol === "https:" ? "443" : "80");
  return `https://${location.hostname}:${port}`;
}

/** A phone that trusts the cell gets the file over HTTPS; another one gets nothing at all. */
export async function lookForCertificate(): Promise<void> {
  try {
    await fetch(securedOrigin() + CERTIFICATE, { mode: "no-cors", cache: "no-store" });
    trusted.value = true;
  } catch {
    trusted.value = false;
  }
}
