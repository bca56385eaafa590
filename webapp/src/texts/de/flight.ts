// German words of the flight record on a motion's page.
import type { Texts } from "..";

export const flight: Texts["flight"] = {
  replay: "Noch einmal ansehen",
  play: "Abspielen",
  pause: "Anhalten",
  slider: "Zeit in der Bewegung",
  at: (at: string, end: string) => `${at} von ${end}`,
  phases: {
    approach: "Fährt zum Anfang",
    motion: "Macht die Bewegung",
    paused: "Pause",
    settling: "Kommt zur Ruhe",
    stopping: "Stoppt",
  },
  jointsAt: "Achswinkel zu dieser Zeit",
  joint: "Achse",
  planned: "Soll",
  measured: "Ist",
  off: "Abw.",
  errorPlot: "Abweichung vom Plan, in Grad",
  errorSummary: (joint: number, most: string) =>
    `Abweichung vom Plan: Achse ${joint} am meisten, höchstens ${most}.`,
  marks: "Gepunktete Linien: Nachrichten des Roboters fehlten oder kamen zu spät.",
  events: "Was geschehen ist",
  none: "Nichts wurde aufgezeichnet: Der Arm hat sich nicht bewegt.",
  byJoint: "Abweichung vom Plan, Achse für Achse",
  most: "Höchstens",
  rms: "Quadratisches Mittel",
  files: "Aufzeichnung mitnehmen",
  csv: "Tabelle (CSV)",
  mcap: "Aufzeichnung (MCAP)",
  counts: {
    cycles: "Regeltakte",
    lost: "Verlorene Nachrichten",
    late: "Verspätete Nachrichten",
    held: "Takte, in denen der Arm angehalten wurde",
    limited: "Takte, verlangsamt wegen der Grenzwerte",
  },
};
