// Italian words of the picture of the arm, and of leading the virtual arm in it.
import type { Texts } from "..";

export const arm3d: Texts["arm3d"] = {
  loading: "Caricamento dell'immagine…",
  missing:
    "Questo telefono non può mostrare il braccio come immagine. I grafici e i numeri mostrano lo stesso.",
  tool: (forward, left, up) =>
    `L'utensile è ${forward} cm davanti, ${left} cm a sinistra e ${up} cm sopra la base.`,
  labels: {
    plan: "Il braccio sul percorso previsto. Il braccio trasparente è alla fine del movimento.",
    flight: "Il braccio com'è stato misurato. Il braccio trasparente è dove lo prevede il piano.",
    take: "Il movimento registrato del braccio.",
    live: "Il braccio com'è adesso.",
  },
  legend: {
    path: "percorso dell'utensile",
    approach: "percorso verso l'inizio",
    band: "dispersione dei Suoi esempi",
    ghostGoal: "fine del movimento",
    ghostPlanned: "posizione prevista",
    planned: "percorso previsto",
  },
  view: {
    title: "Gira l'immagine",
    left: "A sinistra",
    right: "A destra",
    closer: "Più vicino",
    farther: "Più lontano",
    front: "Davanti",
    side: "Lato",
    top: "Dall'alto",
  },
  drag: {
    hint: "Metta un dito sulla sfera e la sposti: il braccio segue.",
    buttons: "Muovi con i pulsanti",
    hold: "Tenga premuto un pulsante per muovere l'utensile.",
    up: "Su",
    down: "Giù",
    left: "Sinistra",
    right: "Destra",
    forward: "Via da Lei",
    back: "Verso di Lei",
    twistLeft: "Ruota a sinistra",
    twistRight: "Ruota a destra",
    tiltLeft: "Inclina a sinistra",
    tiltRight: "Inclina a destra",
    tiltBack: "Inclina verso di Lei",
    tiltAway: "Inclina in là",
    lost: "Il telefono non è collegato. Adesso il braccio non segue.",
  },
  lead: {
    who: "Chi guida il braccio virtuale?",
    name: "Lo guido io",
    detail: "con un dito, nell'immagine del braccio",
    steps: [
      "Qui non c'è un robot vero: Lei guida il braccio virtuale nella sua immagine.",
      "Prema Registra. Dopo 3, 2, 1 la guida manuale è attiva.",
      "Muova con il dito la sfera sull'utensile, poi prema Termina.",
    ],
  },
};
