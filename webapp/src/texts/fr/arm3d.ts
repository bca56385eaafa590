// French words of the picture of the arm, and of leading the virtual arm in it.
import type { Texts } from "..";

export const arm3d: Texts["arm3d"] = {
  loading: "Chargement de l'image…",
  missing:
    "Ce téléphone ne peut pas montrer le bras en image. Les courbes et les chiffres montrent la même chose.",
  tool: (forward, left, up) =>
    `L'outil est à ${forward} cm devant, ${left} cm à gauche et ${up} cm au-dessus du socle.`,
  labels: {
    plan: "Le bras sur son trajet prévu. Le bras transparent est à la fin du mouvement.",
    flight: "Le bras tel qu'il a été mesuré. Le bras transparent est là où le plan le prévoit.",
    take: "Le mouvement enregistré du bras.",
    live: "Le bras tel qu'il est maintenant.",
  },
  legend: {
    path: "trajet de l'outil",
    approach: "trajet vers le départ",
    band: "dispersion de vos exemples",
    ghostGoal: "fin du mouvement",
    ghostPlanned: "position prévue",
    planned: "trajet prévu",
  },
  view: {
    title: "Tourner l'image",
    left: "Vers la gauche",
    right: "Vers la droite",
    closer: "Plus près",
    farther: "Plus loin",
    front: "Face",
    side: "Côté",
    top: "Dessus",
  },
  drag: {
    hint: "Posez un doigt sur la boule et déplacez-la : le bras suit.",
    buttons: "Bouger avec des boutons",
    hold: "Maintenez un bouton appuyé pour déplacer l'outil.",
    up: "Monter",
    down: "Descendre",
    left: "À gauche",
    right: "À droite",
    forward: "S'éloigner",
    back: "Se rapprocher",
    twistLeft: "Tourner à gauche",
    twistRight: "Tourner à droite",
    tiltLeft: "Pencher à gauche",
    tiltRight: "Pencher à droite",
    tiltBack: "Pencher vers vous",
    tiltAway: "Pencher au loin",
    lost: "Le téléphone n'est pas connecté. Le bras ne suit pas pour l'instant.",
  },
  lead: {
    who: "Qui guide le bras virtuel ?",
    name: "Je le guide moi-même",
    detail: "avec un doigt, sur l'image du bras",
    steps: [
      "Pas de vrai robot ici : vous guidez le bras virtuel sur son image.",
      "Appuyez sur Enregistrer. Après 3, 2, 1, le guidage manuel est actif.",
      "Déplacez du doigt la boule sur l'outil, puis appuyez sur Terminer.",
    ],
  },
};
