// German words of saved positions.
import type { Texts } from "..";

export const positions: Texts["positions"] = {
  title: "Gespeicherte Positionen",
  manage: "Gespeicherte Positionen",
  choice: { name: "Gespeicherte Position", detail: "eine Stelle, die einen Namen hat" },
  goal: "An welcher gespeicherten Position soll sie enden?",
  start: "An welcher gespeicherten Position soll sie beginnen?",
  none: "Es ist noch keine Position gespeichert. Bringen Sie den Arm an eine Stelle und speichern Sie sie.",
  noneHere: "Für diesen Roboter ist noch keine Position gespeichert.",
  chooseFirst: "Wählen Sie zuerst eine gespeicherte Position.",
  save: "Speichern, wo der Arm jetzt steht",
  saving: "Wird gespeichert…",
  newName: (number: string) => `Position ${number}`,
  saved: (name: string) => `Gespeichert als ${name}. Sie können ihr einen besseren Namen geben.`,
  angles: (angles: string) => `Achsen bei ${angles}`,
  edit: (name: string) => `${name} ändern`,
  close: "Schließen",
  name: "Name der Position",
  nameMissing: "Tippen Sie zuerst einen Namen.",
  rename: "Umbenennen",
  move: "Dorthin verlegen, wo der Arm jetzt steht",
  moveAsk: (name: string) =>
    `${name} steht dann für die Stelle, an der der Arm jetzt ist. Soll sie verlegt werden?`,
  moveYes: "Ja, verlegen",
  remove: "Diese Position löschen",
  removeAsk: (name: string) =>
    `${name} kann dann nicht mehr gewählt werden. Soll die Position gelöscht werden?`,
  removeYes: "Ja, löschen",
  no: "Nein, behalten",
};
