// Italian words of teaching in one go: the next take, pause, cutting, pictures, undo, the verdict.
import type { Texts } from "..";

export const teaching: Texts["teaching"] = {
  keepAnother: "Conserva, un altro",
  keepTrain: "Conserva e addestra",
  change: "Modifica",
  planning: "Preparazione del movimento…",

  next: {
    wait: "Il prossimo esempio inizia appena il braccio è pronto.",
    bringBack: "Riporti il braccio all'inizio del movimento. La guida manuale è attiva.",
    begins: "La registrazione inizia tra",
    now: "Registra ora",
    more: "Altri 10 s",
    softening: "Attivazione della guida manuale…",
  },

  pause: {
    press: "Pausa",
    pausing: "Messa in pausa…",
    paused: "In pausa",
    explain: "Ora non si registra nulla. La guida manuale è attiva: tenga il braccio.",
    here: "Il braccio è dove ha fatto la pausa. Può continuare.",
    off: (joint, degrees) =>
      `L'asse ${joint} è a ${degrees} dal punto della pausa. Riporti lì il braccio.`,
    unknown: "Non si sa dove sia ora il braccio.",
    goOn: "Continua",
    goingOn: "Ripresa…",
    notHere: "Non ancora lì.",
    notHand: "La mano virtuale non può essere messa in pausa.",
    count: "Pause",
  },

  trim: {
    title: "Taglia le estremità",
    explain: "Tagli ciò che non fa parte del movimento. Nulla va perso: può tornare indietro.",
    begins: "Inizia a",
    ends: "Finisce a",
    move: (end, step) => `${end}: ${step}`,
    save: "Taglia",
    saving: "Taglio in corso…",
    unchanged: "Sposti prima l'inizio o la fine.",
    whole: "Di nuovo l'esempio intero",
    restoring: "Ripristino…",
    isCut: (before, after) => `Tagliato: ${before} all'inizio, ${after} alla fine.`,
    stands: (before, after) =>
      `Il braccio resta fermo per ${before} all'inizio e ${after} alla fine.`,
    standsFirst: (before) => `Il braccio resta fermo per ${before} all'inizio.`,
    standsLast: (after) => `Il braccio resta fermo per ${after} alla fine.`,
    accept: "Taglia questo",
    used: "Usato",
    changedSince:
      "Dopo questo addestramento alcuni esempi sono stati tagliati o scelti diversamente. Addestri di nuovo per tenerne conto.",
  },

  picture: {
    title: "Immagine",
    explain: "Un'immagine aiuta a trovare il compito senza leggere.",
    take: "Scatta una foto",
    choose: "Scegli una foto",
    remove: "Togli l'immagine",
    removing: "Rimozione…",
    preparing: "Preparazione dell'immagine…",
    unreadable: "Questo file non può essere mostrato come immagine.",
    chooseOther: "Scelga un'altra foto.",
  },

  undo: {
    press: "Annulla",
    undoing: "Annullamento…",
    kept: (take) => `L'esempio ${take} è conservato.`,
    discarded: (take) => `L'esempio ${take} è scartato.`,
    deleted: (name) => `«${name}» è stato eliminato.`,
  },

  verdict: {
    green: {
      word: "Buono",
      sentence: "Il braccio fa ciò che ha mostrato, e i Suoi esempi concordano.",
    },
    amber: {
      word: "Usabile con cautela",
      far: "Il percorso è un po' più lontano dai Suoi esempi di quanto lo siano tra loro.",
      few: "Imparato da un solo esempio: contiene anche gli errori della mano.",
      disagree: "I Suoi esempi non concordano ancora del tutto.",
    },
    red: {
      word: "Non usare",
      far: "Il percorso è lontano da ciò che ha mostrato. Registri di nuovo il movimento.",
      goal: "Il braccio mancherebbe la meta. Registri di nuovo il movimento.",
      shape: "Non è il movimento che ha mostrato. Lo registri di nuovo.",
    },
    remarks: "Osservazioni",
  },
};
