// Italian words for the state of the robot and of the connection to it.
import type { Texts } from "..";

export const robot: Texts["robot"] = {
  bar: "Robot",
  states: {
    disconnected: "Non collegato",
    none: "Nessun robot",
    idle: "Pronto",
    guiding: "Guida manuale",
    reproducing: "In movimento",
    stopping: "Arresto",
    faulted: "Guasto",
    unknown: "Non ancora noto",
  },
  connecting: "Collegamento…",
  offline: "Non in linea",
  offlineWork:
    "Questo telefono non è in linea. I dati mostrati sono vecchi. Quando il telefono è di nuovo collegato, tutto riprende da solo.",
  now: "dal vivo",
  ago: (state: string, age: string) => `${state}, ${age} fa`,
  old: (age: string) => `vecchio: ${age}`,
  happened: "Che cosa è successo",
  todo: "Che cosa fare",
  acknowledge: "Ho controllato il robot",
  acknowledging: "Richiesta al robot…",
  soft: {
    title: "Muovi il braccio a mano",
    explain:
      "Attivi la guida manuale per riportare il braccio all'inizio. Intanto non si registra nulla.",
    on: "Attiva la guida manuale",
    off: "Disattiva la guida manuale",
    turningOn: "Attivazione…",
    turningOff: "Disattivazione…",
    isSoft:
      "La guida manuale è attiva: il braccio si muove quando Lei lo spinge. La disattivi quando il braccio è dove vuole.",
    handBack: "Mano virtuale: riporta all'inizio",
    handMoving: "La mano virtuale riporta il braccio…",
  },
  why: {
    disconnected: "Il robot non è collegato.",
    guiding: "La guida manuale è attiva. Prima la disattivi.",
    reproducing: "Il braccio è in movimento.",
    stopping: "Il braccio si sta fermando.",
    faulted: "C'è un guasto. Guardi in alto nella pagina.",
    offline: "Questo telefono non è collegato al server.",
  },
};
