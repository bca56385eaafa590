// German words for what a worker says after a run: the outcome and the questionnaire.
import type { Texts } from "..";

export const feedback: Texts["feedback"] = {
  question: "Hat es geklappt?",
  worked: "Hat geklappt",
  failed: "Hat nicht geklappt",
  thanks: "Ist notiert. Sie können es ändern.",
  takeBack: "Zurücknehmen",
  note: "Was ging schief? (Sie können das weglassen.)",
  saveNote: "Notiz speichern",
  noteSaved: "Die Notiz ist gespeichert.",
  saving: "Wird gespeichert…",

  recent: "Letzte Ausführungen",

  invite: "Fünf kurze Fragen",
  inviteDetail: "Wie finden Sie die Arbeit mit dem Arm? Es werden keine Namen gespeichert.",
  answer: "Antworten",
  skip: "Nicht in dieser Schicht",
  skipping: "Wird geschlossen…",
  title: "Fünf kurze Fragen",
  explain: "1 heißt gar nicht, 5 heißt völlig.",
  lowest: "Gar nicht",
  highest: "Völlig",
  scale: {
    "1": "1, gar nicht",
    "2": "2, eher nicht",
    "3": "3, unentschieden",
    "4": "4, größtenteils",
    "5": "5, völlig",
  },
  statements: {
    learned: "Der Arm hat die richtige Bewegung gelernt.",
    safe: "Bei der Arbeit mit dem Arm habe ich mich sicher gefühlt.",
    accurate: "Der Arm ist genau ans Ziel gekommen.",
    simple: "Es war leicht, dem Arm eine Bewegung beizubringen.",
    enjoyable: "Es hat Spaß gemacht, dem Arm eine Bewegung beizubringen.",
  },
  missing: (left: string) => `Noch offen: ${left}`,
  send: "Senden",
  sending: "Wird gesendet…",
};
