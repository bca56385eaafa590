// Every Italian word the app shows, grouped by screen, with the formal Lei: instructions in the
// form of the Lei, buttons short and without a person ("Registra", "Conserva").
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

export const it: Texts = {
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
    sections: "Sezioni",
    teach: "Insegna",
    run: "Esegui",
    back: "Indietro",
    loading: "Caricamento…",
    tryAgain: "Riprova",
    cancel: "Annulla",
    pageMissing: "Questa pagina non esiste",
    toTeach: "Vai a Insegna",
  },
  problems: {
    whatWasWrong: "Che cosa non va",
    whatToDo: "Che cosa fare",
    where: "Dove",
    refused: (status: number) => `Il server ha rifiutato (${status}).`,
    tryAgain: "Riprovi. Se succede di nuovo, chieda aiuto.",
    unreachable: "Il server non risponde.",
    checkNetwork: "Controlli che il telefono sia nella rete del robot, poi riprovi.",
    places: {
      take: (value: string) => `esempio ${value}`,
      row: (value: string) => `riga ${value}`,
      joint: (value: string) => `asse ${value}`,
      t_s: (value: string) => `dopo ${value}\u00a0s`,
    },
  },
  stop: {
    button: "Stop",
    sending: "Arresto in corso…",
    sent: "Il comando di arresto è arrivato",
    failed: "Il comando di arresto forse non è arrivato. Usi l'arresto di emergenza del robot.",
  },
  pairing: {
    title: "Collega il telefono",
    explain: "Scriva il codice che compare sullo schermo del computer TEAM.",
    code: "Codice",
    connect: "Collega",
    connecting: "Collegamento…",
  },
  plot: {
    joint: (number: number) => `Asse ${number}`,
    short: (number: number) => `A${number}`,
    degrees: "gradi",
    seconds: "secondi",
    live: "Gli ultimi dieci secondi di tutti e sei gli assi",
    summary: (title: string, seconds: string, widest: number, travel: string) =>
      `${title}: ${seconds}. Si muove di più l'asse ${widest}, di ${travel}.`,
    numbers: "In cifre",
    start: "Inizio",
    end: "Fine",
    lowest: "Min.",
    highest: "Max.",
    missing: "Non è stato possibile caricare il grafico.",
    empty: "Ancora nulla di registrato",
  },
  units: {
    degrees: (value: string) => `${value}°`,
    below: (value: string) => `meno di ${value}`,
    millimetres: (value: string) => `${value}\u00a0mm`,
    seconds: (value: string) => `${value}\u00a0s`,
    minutes: (minutes: number, seconds: string) => `${minutes}:${seconds}\u00a0min`,
    percent: (value: string) => `${value}%`,
  },
};
