// Italian words for the page with all robots of the cell.
import type { Texts } from "..";

export const robots: Texts["robots"] = {
  title: "Robot",
  choose: "Prema il robot davanti a Lei.",
  chooseFirst: "Ci sono più robot. Prema quello davanti a Lei.",
  change: (name: string) => `Robot ${name}. Scegli un altro robot`,
  noJoints: "La sua posizione non è nota",
  jointsNow: "Assi misurati proprio ora",
  jointsAge: (age: string) => `Assi misurati ${age} fa`,
  egmNever: "Collegamento di controllo: non ancora usato",
  egmOn: "attivo",
  egmOff: "a riposo",
  priority: "con priorità",
  noPriority: "senza priorità",
  egm: (link: string, lost: number, late: number, priority: string) =>
    `Collegamento di controllo: ${link}, messaggi persi: ${lost}, in ritardo: ${late}, ${priority}`,
};
