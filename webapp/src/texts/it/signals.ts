// Italian words about signals: the gripper and its like. Their names come from the cell.
import type { Texts } from "..";

export const signals: Texts["signals"] = {
  group: "Pinza e segnali",
  press: (label: string, verb: string) => `${label}: ${verb}`,
  stands: (label: string, verb: string) => `${label}, posizione attuale: ${verb}.`,
  unknown: (label: string) => `${label}: posizione sconosciuta.`,
  setting: (label: string) => `${label}…`,
  notWhileMoving: "Ci pensa da solo il movimento.",
  recorded: "Azionato durante la registrazione",
  planned: "Azionato lungo il percorso",
  done: "Azionato dal movimento",
  at: (time: string) => `a ${time}`,
};
