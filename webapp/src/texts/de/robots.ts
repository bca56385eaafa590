// German words for the page with all robots of the cell.
import type { Texts } from "..";

export const robots: Texts["robots"] = {
  title: "Roboter",
  choose: "Drücken Sie den Roboter, an dem Sie stehen.",
  chooseFirst: "Es gibt mehrere Roboter. Drücken Sie den, an dem Sie stehen.",
  change: (name: string) => `Roboter ${name}. Anderen Roboter wählen`,
  noJoints: "Seine Stellung ist nicht bekannt",
  jointsNow: "Achsen soeben gemessen",
  jointsAge: (age: string) => `Achsen vor ${age} gemessen`,
  egmNever: "Regelverbindung: noch nicht benutzt",
  egmOn: "an",
  egmOff: "ruht",
  priority: "mit Vorrang",
  noPriority: "ohne Vorrang",
  egm: (link: string, lost: number, late: number, priority: string) =>
    `Regelverbindung: ${link}, ${lost} verloren, ${late} verspätet, ${priority}`,
};
