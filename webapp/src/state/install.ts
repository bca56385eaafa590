// Putting the app on the phone's home screen, where the browser offers it.
import { signal } from "@preact/signals";

/** What Chromium browsers hand out; it is in no standard. */
interface InstallPrompt extends Event {
  prompt(): Promise<{ outcome: "accepted" | "dismissed" }>;
}

/** The browser's offer, as long as it stands. */
export const installOffer = signal<InstallPrompt | null>(null);

/** The browser asks by itself when it likes; we keep its offer for our own quiet button. */
export function waitForInstallOffer(): void {
  window.addEventListener("beforeinstallprompt", (event) => {
    event.preventDefault();
    installOffer.value = event as InstallPrompt;
  });
  window.addEventListener("appinstalled", () => (installOffer.value = null));
}

export async function install(): Promise<void> {
  const offer = installOffer.peek();
  // Each offer can be taken once only.
  installOffer.value = null;
  await offer?.prompt();
}

/** Opened from the home screen. */
export function isInstalled(): boolean {
  return matchMedia("(display-mode: standalone)").matches;
}

export type Platform = "iphone" | "android" | "other";

export function platform(agent: string, touchPoints: number): Platform {
  if (/android/i.test(agent)) return "android";
  // An iPad says that it is a Mac, but no Mac has a touch screen.
  if (/iphone|ipad|ipod/i.test(agent) || (/macintosh/i.test(agent) && touchPoints > 1)) {
    return "iphone";
  }
  return "other";
}
