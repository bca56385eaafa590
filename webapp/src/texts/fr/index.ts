// Every French word the app shows, grouped by screen, with the formal vous. The spaces before : ; ? !
// are plain here; typography.ts makes them such that no line ends there.
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

export const fr: Texts = {
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
    sections: "Rubriques",
    teach: "Apprendre",
    run: "Exécuter",
    back: "Retour",
    loading: "Chargement…",
    tryAgain: "Réessayer",
    cancel: "Annuler",
    pageMissing: "Cette page n'existe pas",
    toTeach: "Aller à Apprendre",
  },
  problems: {
    whatWasWrong: "Ce qui n'a pas marché",
    whatToDo: "Ce qu'il faut faire",
    where: "Où",
    refused: (status: number) => `Le serveur a refusé (${status}).`,
    tryAgain: "Réessayez. Si cela recommence, demandez de l'aide.",
    unreachable: "Le serveur ne répond pas.",
    checkNetwork: "Vérifiez que le téléphone est sur le réseau du robot, puis réessayez.",
    places: {
      take: (value: string) => `exemple ${value}`,
      row: (value: string) => `ligne ${value}`,
      joint: (value: string) => `axe ${value}`,
      t_s: (value: string) => `après ${value}\u00a0s`,
    },
  },
  stop: {
    button: "Stop",
    sending: "Arrêt en cours…",
    sent: "L'ordre d'arrêt est passé",
    failed: "L'ordre d'arrêt n'est peut-être pas passé. Utilisez l'arrêt d'urgence du robot.",
  },
  pairing: {
    title: "Connecter le téléphone",
    explain: "Tapez le code affiché sur l'écran de l'ordinateur TEAM.",
    code: "Code",
    connect: "Connecter",
    connecting: "Connexion…",
  },
  plot: {
    joint: (number: number) => `Axe ${number}`,
    short: (number: number) => `A${number}`,
    degrees: "degrés",
    seconds: "secondes",
    live: "Les dix dernières secondes des six axes",
    summary: (title: string, seconds: string, widest: number, travel: string) =>
      `${title} : ${seconds}. C'est l'axe ${widest} qui bouge le plus, de ${travel}.`,
    numbers: "En chiffres",
    start: "Début",
    end: "Fin",
    lowest: "Min.",
    highest: "Max.",
    missing: "La courbe n'a pas pu être chargée.",
    empty: "Rien d'enregistré pour l'instant",
  },
  units: {
    degrees: (value: string) => `${value}°`,
    below: (value: string) => `moins de ${value}`,
    millimetres: (value: string) => `${value}\u00a0mm`,
    seconds: (value: string) => `${value}\u00a0s`,
    minutes: (minutes: number, seconds: string) => `${minutes}:${seconds}\u00a0min`,
    percent: (value: string) => `${value}\u202f%`,
  },
};
