// Every German word the app shows, grouped by screen, with the formal Sie. The ß stands as in
// Germany; typography.ts writes ss for phones of Switzerland.
import type { Texts } from "..";
import { arm3d } from "./arm3d";
import { control, hold } from "./control";
import { dashboard } from "./dashboard";
import { feedback } from "./feedback";
import { flight } from "./flight";
import { language } from "./language";
import { phones } from "./phones";
import { positions } from "./positions";
import { robot } from "./robot";
import { robots } from "./robots";
import { run } from "./run";
import { signals } from "./signals";
import { teach } from "./teach";
import { teaching } from "./teaching";

export const de: Texts = {
  arm3d,
  control,
  dashboard,
  feedback,
  flight,
  hold,
  language,
  phones,
  positions,
  robot,
  robots,
  run,
  signals,
  teach,
  teaching,
  app: {
    name: "TEAM",
    sections: "Bereiche",
    teach: "Anlernen",
    run: "Ausführen",
    back: "Zurück",
    loading: "Wird geladen…",
    tryAgain: "Noch einmal versuchen",
    cancel: "Abbrechen",
    pageMissing: "Diese Seite gibt es nicht",
    toTeach: "Zum Anlernen",
  },
  problems: {
    whatWasWrong: "Was nicht ging",
    whatToDo: "Was zu tun ist",
    where: "Wo",
    refused: (status: number) => `Der Server hat das abgelehnt (${status}).`,
    tryAgain: "Versuchen Sie es noch einmal. Wenn es wieder nicht geht, holen Sie Hilfe.",
    unreachable: "Der Server antwortet nicht.",
    checkNetwork:
      "Prüfen Sie, ob das Telefon im Netz des Roboters ist. Versuchen Sie es dann noch einmal.",
    places: {
      take: (value: string) => `Aufnahme ${value}`,
      row: (value: string) => `Zeile ${value}`,
      joint: (value: string) => `Achse ${value}`,
      t_s: (value: string) => `nach ${value} s`,
    },
  },
  stop: {
    button: "Stopp",
    sending: "Stoppt…",
    sent: "Stopp ist angekommen",
    failed: "Stopp ist vielleicht nicht angekommen. Drücken Sie den Not-Halt des Roboters.",
  },
  pairing: {
    title: "Telefon verbinden",
    explain: "Tippen Sie den Code ein, den der Bildschirm des TEAM-Rechners zeigt.",
    code: "Code",
    connect: "Verbinden",
    connecting: "Verbindet…",
  },
  plot: {
    joint: (number: number) => `Achse ${number}`,
    short: (number: number) => `A${number}`,
    degrees: "Grad",
    seconds: "Sekunden",
    live: "Die letzten zehn Sekunden aller sechs Achsen",
    summary: (title: string, seconds: string, widest: number, travel: string) =>
      `${title}: ${seconds}. Am meisten bewegt sich Achse ${widest}, um ${travel}.`,
    numbers: "Als Zahlen",
    start: "Anfang",
    end: "Ende",
    lowest: "Min.",
    highest: "Max.",
    missing: "Die Kurve konnte nicht geladen werden.",
    empty: "Noch nichts aufgenommen",
  },
  units: {
    degrees: (value: string) => `${value}°`,
    below: (value: string) => `unter ${value}`,
    millimetres: (value: string) => `${value}\u00a0mm`,
    seconds: (value: string) => `${value}\u00a0s`,
    minutes: (minutes: number, seconds: string) => `${minutes}:${seconds}\u00a0min`,
    percent: (value: string) => `${value}\u00a0%`,
  },
};
