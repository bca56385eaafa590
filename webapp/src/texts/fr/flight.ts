// French words of the flight record on a motion's page.
import type { Texts } from "..";

export const flight: Texts["flight"] = {
  replay: "Revoir le mouvement",
  play: "Lire",
  pause: "Pause",
  slider: "Moment du mouvement",
  at: (at: string, end: string) => `${at} sur ${end}`,
  phases: {
    approach: "Va au départ",
    motion: "Fait le mouvement",
    paused: "En pause",
    settling: "S'immobilise",
    stopping: "S'arrête",
  },
  jointsAt: "Angles des axes à ce moment",
  joint: "Axe",
  planned: "Prévu",
  measured: "Mesuré",
  off: "Écart",
  errorPlot: "Écart au plan, en degrés",
  errorSummary: (joint: number, most: string) =>
    `Écart au plan : le plus grand est celui de l'axe ${joint}, ${most} au maximum.`,
  marks: "Traits pointillés : des messages du robot ont été perdus ou sont arrivés en retard.",
  events: "Ce qui s'est passé",
  none: "Rien n'a été enregistré : le bras n'a pas bougé.",
  byJoint: "Écart au plan, axe par axe",
  most: "Maximum",
  rms: "Moyenne quadratique",
  files: "Emporter l'enregistrement",
  csv: "Tableau (CSV)",
  mcap: "Enregistrement (MCAP)",
  counts: {
    cycles: "Cycles de commande",
    lost: "Messages perdus",
    late: "Messages en retard",
    held: "Cycles où le bras a été retenu",
    limited: "Cycles ralentis pour respecter les limites",
  },
};
