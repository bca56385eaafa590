// French words for the state of the robot and of the connection to it.
import type { Texts } from "..";

export const robot: Texts["robot"] = {
  bar: "Robot",
  states: {
    disconnected: "Non connecté",
    none: "Pas de robot",
    idle: "Prêt",
    guiding: "Guidage manuel",
    reproducing: "En mouvement",
    stopping: "S'arrête",
    faulted: "Défaut",
    unknown: "Pas encore connu",
  },
  connecting: "Connexion…",
  offline: "Hors ligne",
  offlineWork:
    "Ce téléphone est hors ligne. Ce qui est affiché est ancien. Tout reprend sans rien faire dès que le téléphone est reconnecté.",
  now: "en direct",
  ago: (state: string, age: string) => `${state}, il y a ${age}`,
  old: (age: string) => `ancien : ${age}`,
  happened: "Ce qui s'est passé",
  todo: "Ce qu'il faut faire",
  acknowledge: "J'ai contrôlé le robot",
  acknowledging: "Demande au robot…",
  soft: {
    title: "Bouger le bras à la main",
    explain:
      "Activez le guidage manuel pour ramener le bras au départ. Rien n'est enregistré pendant ce temps.",
    on: "Activer le guidage manuel",
    off: "Couper le guidage manuel",
    turningOn: "Activation…",
    turningOff: "Coupure…",
    isSoft:
      "Le guidage manuel est actif : le bras bouge quand vous le poussez. Coupez-le quand le bras est où vous voulez.",
    handBack: "Main virtuelle : ramener au départ",
    handMoving: "La main virtuelle ramène le bras…",
  },
  why: {
    disconnected: "Le robot n'est pas connecté.",
    guiding: "Le guidage manuel est actif. Coupez-le d'abord.",
    reproducing: "Le bras est en mouvement.",
    stopping: "Le bras est en train de s'arrêter.",
    faulted: "Il y a un défaut. Regardez en haut de la page.",
    offline: "Ce téléphone n'est pas connecté au serveur.",
  },
};
