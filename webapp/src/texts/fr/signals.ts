// French words about signals: the gripper and its like. Their names come from the cell.
import type { Texts } from "..";

export const signals: Texts["signals"] = {
  group: "Pince et signaux",
  press: (label: string, verb: string) => `${label} : ${verb}`,
  stands: (label: string, verb: string) => `${label}, position actuelle : ${verb}.`,
  unknown: (label: string) => `${label} : position inconnue.`,
  setting: (label: string) => `${label}…`,
  notWhileMoving: "Le mouvement s'en charge tout seul.",
  recorded: "Actionné pendant l'enregistrement",
  planned: "Actionné en chemin",
  done: "Actionné par le mouvement",
  at: (time: string) => `à ${time}`,
};
