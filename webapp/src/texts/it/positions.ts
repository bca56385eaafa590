// Italian words of saved positions.
import type { Texts } from "..";

export const positions: Texts["positions"] = {
  title: "Posizioni salvate",
  manage: "Posizioni salvate",
  choice: { name: "Posizione salvata", detail: "un punto a cui è stato dato un nome" },
  goal: "In quale posizione salvata deve finire?",
  start: "In quale posizione salvata deve iniziare?",
  none: "Nessuna posizione è salvata. Porti il braccio in un punto e lo salvi.",
  noneHere: "Nessuna posizione è salvata per questo robot.",
  chooseFirst: "Scelga prima una posizione salvata.",
  save: "Salva dove si trova il braccio",
  saving: "Salvataggio…",
  newName: (number: string) => `Posizione ${number}`,
  saved: (name: string) => `Salvata come ${name}. Può darle un nome migliore.`,
  angles: (angles: string) => `Assi a ${angles}`,
  edit: (name: string) => `Modifica ${name}`,
  close: "Chiudi",
  name: "Nome della posizione",
  nameMissing: "Scriva prima un nome.",
  rename: "Rinomina",
  move: "Spostala dove si trova il braccio",
  moveAsk: (name: string) =>
    `${name} indicherà il punto in cui il braccio si trova ora. Va spostata?`,
  moveYes: "Sì, sposta",
  remove: "Elimina questa posizione",
  removeAsk: (name: string) => `${name} non potrà più essere scelta. Va eliminata?`,
  removeYes: "Sì, elimina",
  no: "No, conserva",
};
