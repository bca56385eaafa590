// French words for the page with all robots of the cell.
import type { Texts } from "..";

export const robots: Texts["robots"] = {
  title: "Robots",
  choose: "Appuyez sur le robot devant lequel vous êtes.",
  chooseFirst: "Il y a plusieurs robots. Appuyez sur celui devant lequel vous êtes.",
  change: (name: string) => `Robot ${name}. Choisir un autre robot`,
  noJoints: "Sa position n'est pas connue",
  jointsNow: "Axes mesurés à l'instant",
  jointsAge: (age: string) => `Axes mesurés il y a ${age}`,
  egmNever: "Liaison de commande : pas encore utilisée",
  egmOn: "active",
  egmOff: "au repos",
  priority: "avec priorité",
  noPriority: "sans priorité",
  egm: (link: string, lost: number, late: number, priority: string) =>
    `Liaison de commande : ${link}, messages perdus : ${lost}, en retard : ${late}, ${priority}`,
};
