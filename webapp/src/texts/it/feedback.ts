// Italian words for what a worker says after a run: the outcome and the questionnaire.
import type { Texts } from "..";

export const feedback: Texts["feedback"] = {
  question: "Il lavoro è riuscito?",
  worked: "È riuscito",
  failed: "Non è riuscito",
  thanks: "Annotato. Può cambiare la risposta.",
  takeBack: "Annulla la risposta",
  note: "Che cosa non ha funzionato? (Facoltativo.)",
  saveNote: "Salva la nota",
  noteSaved: "La nota è salvata.",
  saving: "Salvataggio…",

  recent: "Ultime esecuzioni",

  invite: "Cinque domande brevi",
  inviteDetail: "Che cosa pensa del lavoro con il braccio? Non si salvano nomi.",
  answer: "Rispondi",
  skip: "Non in questo turno",
  skipping: "Chiusura…",
  title: "Cinque domande brevi",
  explain: "1 vuol dire per niente, 5 vuol dire del tutto.",
  lowest: "Per niente",
  highest: "Del tutto",
  scale: {
    "1": "1, per niente",
    "2": "2, piuttosto no",
    "3": "3, né sì né no",
    "4": "4, in gran parte",
    "5": "5, del tutto",
  },
  statements: {
    learned: "Il braccio ha imparato il movimento giusto.",
    safe: "Lavorare con il braccio mi è sembrato sicuro.",
    accurate: "Il braccio è arrivato esattamente alla meta.",
    simple: "È stato facile insegnare un movimento al braccio.",
    enjoyable: "È stato divertente insegnare un movimento al braccio.",
  },
  missing: (left: string) => `Ancora da rispondere: ${left}`,
  send: "Invia",
  sending: "Invio…",
};
