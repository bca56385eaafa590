// French words of teaching in one go: the next take, pause, cutting, pictures, undo, the verdict.
import type { Texts } from "..";

export const teaching: Texts["teaching"] = {
  keepAnother: "Garder, encore un",
  keepTrain: "Garder et entraîner",
  change: "Modifier",
  planning: "Préparation du mouvement…",

  next: {
    wait: "L'exemple suivant commence dès que le bras est prêt.",
    bringBack: "Ramenez le bras au départ du mouvement. Le guidage manuel est actif.",
    begins: "L'enregistrement commence dans",
    now: "Enregistrer maintenant",
    more: "10 s de plus",
    softening: "Activation du guidage manuel…",
  },

  pause: {
    press: "Pause",
    pausing: "Mise en pause…",
    paused: "En pause",
    explain: "Rien n'est enregistré maintenant. Le guidage manuel est actif : tenez le bras.",
    here: "Le bras est là où vous avez fait la pause. Vous pouvez continuer.",
    off: (joint, degrees) =>
      `L'axe ${joint} est à ${degrees} de l'endroit de la pause. Ramenez-y le bras.`,
    unknown: "On ne sait pas où est le bras maintenant.",
    goOn: "Continuer",
    goingOn: "Reprise…",
    notHere: "Pas encore là.",
    notHand: "La main virtuelle ne peut pas être mise en pause.",
    count: "Nombre de pauses",
  },

  trim: {
    title: "Couper les bouts",
    explain:
      "Coupez ce qui ne fait pas partie du mouvement. Rien n'est perdu : vous pouvez revenir en arrière.",
    begins: "Commence à",
    ends: "Finit à",
    move: (end, step) => `${end} : ${step}`,
    save: "Couper",
    saving: "Coupe en cours…",
    unchanged: "Déplacez d'abord le début ou la fin.",
    whole: "Reprendre l'exemple entier",
    restoring: "Retour en arrière…",
    isCut: (before, after) => `Coupé : ${before} au début, ${after} à la fin.`,
    stands: (before, after) =>
      `Le bras reste immobile pendant ${before} au début et ${after} à la fin.`,
    standsFirst: (before) => `Le bras reste immobile pendant ${before} au début.`,
    standsLast: (after) => `Le bras reste immobile pendant ${after} à la fin.`,
    accept: "Couper cela",
    used: "Utilisé",
    changedSince:
      "Des exemples ont été coupés ou choisis autrement depuis cet entraînement. Entraînez de nouveau pour en tenir compte.",
  },

  picture: {
    title: "Image",
    explain: "Une image aide à trouver la tâche sans lire.",
    take: "Prendre une photo",
    choose: "Choisir une image",
    remove: "Retirer l'image",
    removing: "Retrait en cours…",
    preparing: "Préparation de l'image…",
    unreadable: "Ce fichier ne peut pas être montré comme image.",
    chooseOther: "Choisissez une autre photo.",
  },

  undo: {
    press: "Annuler",
    undoing: "Annulation…",
    kept: (take) => `L'exemple ${take} est gardé.`,
    discarded: (take) => `L'exemple ${take} est écarté.`,
    deleted: (name) => `« ${name} » est supprimée.`,
  },

  verdict: {
    green: {
      word: "Bon",
      sentence: "Le bras fait ce que vous avez montré, et vos exemples concordent.",
    },
    amber: {
      word: "Utilisable avec prudence",
      far: "Le trajet est un peu plus loin de vos exemples qu'ils ne le sont entre eux.",
      few: "Appris d'un seul exemple : les faux mouvements de la main y sont aussi.",
      disagree: "Vos exemples ne concordent pas encore tout à fait.",
    },
    red: {
      word: "Ne pas utiliser",
      far: "Le trajet est loin de ce que vous avez montré. Enregistrez de nouveau le mouvement.",
      goal: "Le bras manquerait le but. Enregistrez de nouveau le mouvement.",
      shape: "Ce n'est pas le mouvement que vous avez montré. Enregistrez-le de nouveau.",
    },
    remarks: "Remarques",
  },
};
