// Italian words about which phone controls the robot, and about holding the button.
import type { Texts } from "..";

export const control: Texts["control"] = {
  nameless: (end: string) => `Telefono ${end}`,
  other: (name: string) => `${name} comanda questo robot.`,
  ask: "Chiedi il comando",
  asking: "Richiesta in corso…",
  asked: "Richiesto. Attenda la risposta.",
  wants: (name: string) => `${name} chiede il comando di questo robot.`,
  give: "Cedi",
  keep: "Tieni",
  title: "Comando del robot",
  phoneName: "Nome di questo telefono",
  phoneNameHint: "Gli altri lo vedono quando Lei comanda un robot.",
  save: "Salva",
};

export const hold: Texts["hold"] = {
  mode: "Come deve muoversi il braccio?",
  modes: {
    held: {
      name: "Finché tengo premuto",
      detail: "appena lascia, il braccio si ferma",
    },
    alone: { name: "Da solo", detail: "una volta avviato, fino alla fine" },
  },
  onlyHeld: "Questo robot si muove solo finché tiene premuto il pulsante.",
  ready: "Prepara",
  gettingReady: "Preparazione del braccio…",
  nothingMoves: "Non si muove ancora nulla: nella prossima pagina terrà premuto un pulsante.",
  button: "Tieni premuto per muovere",
  holding: "In movimento – lasci per fermare",
  waits: "Il braccio La aspetta",
  keepClear: "Stia a distanza: il braccio si muove finché preme.",
  keys: "Con la tastiera: tenga premuta la barra spaziatrice.",
};
