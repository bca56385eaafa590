// French words of saved positions.
import type { Texts } from "..";

export const positions: Texts["positions"] = {
  title: "Positions enregistrées",
  manage: "Positions enregistrées",
  choice: { name: "Position enregistrée", detail: "un endroit qui porte un nom" },
  goal: "À quelle position enregistrée doit-il finir ?",
  start: "À quelle position enregistrée doit-il commencer ?",
  none: "Aucune position n'est enregistrée. Amenez le bras à un endroit et enregistrez-le.",
  noneHere: "Aucune position n'est enregistrée pour ce robot.",
  chooseFirst: "Choisissez d'abord une position enregistrée.",
  save: "Enregistrer l'endroit où est le bras",
  saving: "Enregistrement…",
  newName: (number: string) => `Position ${number}`,
  saved: (name: string) => `Enregistré sous ${name}. Vous pouvez lui donner un meilleur nom.`,
  angles: (angles: string) => `Axes à ${angles}`,
  edit: (name: string) => `Modifier ${name}`,
  close: "Fermer",
  name: "Nom de la position",
  nameMissing: "Tapez d'abord un nom.",
  rename: "Renommer",
  move: "La déplacer là où est le bras",
  moveAsk: (name: string) =>
    `${name} désignera l'endroit où est le bras maintenant. Faut-il la déplacer ?`,
  moveYes: "Oui, déplacer",
  remove: "Supprimer cette position",
  removeAsk: (name: string) => `${name} ne pourra plus être choisie. Faut-il la supprimer ?`,
  removeYes: "Oui, supprimer",
  no: "Non, garder",
};
