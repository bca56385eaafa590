// Italian words of the flight record on a motion's page.
import type { Texts } from "..";

export const flight: Texts["flight"] = {
  replay: "Rivedi il movimento",
  play: "Riproduci",
  pause: "Pausa",
  slider: "Momento del movimento",
  at: (at: string, end: string) => `${at} di ${end}`,
  phases: {
    approach: "Va all'inizio",
    motion: "Esegue il movimento",
    paused: "In pausa",
    settling: "Si sta fermando",
    stopping: "Arresto",
  },
  jointsAt: "Angoli degli assi in questo momento",
  joint: "Asse",
  planned: "Previsto",
  measured: "Misurato",
  off: "Scarto",
  errorPlot: "Scarto dal piano, in gradi",
  errorSummary: (joint: number, most: string) =>
    `Scarto dal piano: il più grande è dell'asse ${joint}, al massimo ${most}.`,
  marks: "Linee punteggiate: messaggi del robot persi o arrivati in ritardo.",
  events: "Che cosa è successo",
  none: "Non è stato registrato nulla: il braccio non si è mosso.",
  byJoint: "Scarto dal piano, asse per asse",
  most: "Massimo",
  rms: "Media quadratica",
  files: "Scarica la registrazione",
  csv: "Tabella (CSV)",
  mcap: "Registrazione (MCAP)",
  counts: {
    cycles: "Cicli di controllo",
    lost: "Messaggi persi",
    late: "Messaggi in ritardo",
    held: "Cicli con il braccio trattenuto",
    limited: "Cicli rallentati per restare nei limiti",
  },
};
