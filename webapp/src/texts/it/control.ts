// Italian words about which phone controls the robot, and about holding the button.
export const control = {
  nameless: (end: string) => `Telefono ${end}`,
  other: (name: string) => `${name} comanda questo robot.`,
  ask: "Chiedere il comando",
  asking: "Richiesta in corso…",
  asked: "Richiesto. Attenda la risposta.",
  wants: (name: string) => `${name} chiede il comando di questo robot.`,
  give: "Cedere",
  keep: "Tenere",
  title: "Comando del robot",
  phoneName: "Nome di questo telefono",
  phoneNameHint: "Gli altri lo vedono quando Lei comanda un robot.",
  save: "Salvare",
};

export const hold = {
  mode: "Come deve muoversi?",
  modes: {
    held: {
      name: "Finché tengo il pulsante",
      detail: "quando lo lascia, il braccio si ferma",
    },
    alone: { name: "Da solo", detail: "una volta avviato, fino alla fine" },
  },
  onlyHeld: "Questo robot si muove solo finché Lei tiene il pulsante.",
  ready: "Preparare",
  gettingReady: "Preparazione del braccio…",
  nothingMoves: "Ancora niente si muove: nella prossima pagina tiene un pulsante.",
  button: "Tenere per muovere",
  holding: "In movimento – lasci per fermare",
  waits: "Il braccio La aspetta",
  keepClear: "Stia a distanza. Il braccio si muove finché tiene il pulsante.",
  keys: "Con la tastiera: tenga la barra spaziatrice.",
};
