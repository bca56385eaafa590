// German words about which phone controls the robot, and about holding the button.
import type { Texts } from "..";

export const control: Texts["control"] = {
  nameless: (end: string) => `Telefon ${end}`,
  other: (name: string) => `${name} steuert diesen Roboter.`,
  ask: "Um Steuerung bitten",
  asking: "Anfrage…",
  asked: "Angefragt. Warten Sie auf die Antwort.",
  wants: (name: string) => `${name} bittet um die Steuerung.`,
  give: "Abgeben",
  keep: "Behalten",
  title: "Steuerung des Roboters",
  phoneName: "Name dieses Telefons",
  phoneNameHint: "Andere sehen ihn, wenn Sie einen Roboter steuern.",
  save: "Speichern",
};

export const hold: Texts["hold"] = {
  mode: "Wie soll sich der Arm bewegen?",
  modes: {
    held: {
      name: "Solange ich die Taste halte",
      detail: "lassen Sie los, bleibt der Arm stehen",
    },
    alone: { name: "Von selbst", detail: "einmal gestartet, bis zum Ende" },
  },
  onlyHeld: "Dieser Roboter bewegt sich nur, solange Sie die Taste halten.",
  ready: "Bereit machen",
  gettingReady: "Der Arm wird bereit gemacht…",
  nothingMoves: "Noch bewegt sich nichts: Auf der nächsten Seite halten Sie eine Taste.",
  button: "Zum Bewegen halten",
  holding: "Fährt – zum Anhalten loslassen",
  waits: "Der Arm wartet auf Sie",
  keepClear: "Halten Sie Abstand: Der Arm bewegt sich, solange Sie drücken.",
  keys: "Mit der Tastatur: Halten Sie die Leertaste.",
};
