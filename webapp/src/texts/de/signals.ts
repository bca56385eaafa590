// German words about signals: the gripper and its like. Their names come from the cell.
import type { Texts } from "..";

export const signals: Texts["signals"] = {
  group: "Greifer und Signale",
  press: (label: string, verb: string) => `${label}: ${verb}`,
  stands: (label: string, verb: string) => `${label} steht jetzt auf: ${verb}.`,
  unknown: (label: string) => `${label}: Stellung unbekannt.`,
  setting: (label: string) => `${label} schaltet…`,
  notWhileMoving: "Das macht die Bewegung von selbst.",
  recorded: "Bei der Aufnahme geschaltet",
  planned: "Wird unterwegs geschaltet",
  done: "In der Bewegung geschaltet",
  at: (time: string) => `nach ${time}`,
};
