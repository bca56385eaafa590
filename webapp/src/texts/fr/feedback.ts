// French words for what a worker says after a run: the outcome and the questionnaire.
import type { Texts } from "..";

export const feedback: Texts["feedback"] = {
  question: "Est-ce réussi ?",
  worked: "C'est réussi",
  failed: "C'est raté",
  thanks: "C'est noté. Vous pouvez le changer.",
  takeBack: "Annuler la réponse",
  note: "Qu'est-ce qui n'a pas marché ? (Facultatif.)",
  saveNote: "Enregistrer la note",
  noteSaved: "La note est enregistrée.",
  saving: "Enregistrement…",

  recent: "Dernières exécutions",

  invite: "Cinq questions courtes",
  inviteDetail: "Que pensez-vous du travail avec le bras ? Aucun nom n'est gardé.",
  answer: "Répondre",
  skip: "Pas pendant ce poste",
  skipping: "Fermeture…",
  title: "Cinq questions courtes",
  explain: "1 veut dire pas du tout, 5 veut dire tout à fait.",
  lowest: "Pas du tout",
  highest: "Tout à fait",
  scale: {
    "1": "1, pas du tout",
    "2": "2, plutôt non",
    "3": "3, sans avis",
    "4": "4, plutôt oui",
    "5": "5, tout à fait",
  },
  statements: {
    learned: "Le bras a appris le bon mouvement.",
    safe: "Travailler avec le bras m'a paru sûr.",
    accurate: "Le bras est arrivé exactement au but.",
    simple: "Il était facile d'apprendre un mouvement au bras.",
    enjoyable: "Il était amusant d'apprendre un mouvement au bras.",
  },
  missing: (left: string) => `Reste à répondre : ${left}`,
  send: "Envoyer",
  sending: "Envoi…",
};
