// French words about which phone controls the robot, and about holding the button.
import type { Texts } from "..";

export const control: Texts["control"] = {
  nameless: (end: string) => `Téléphone ${end}`,
  other: (name: string) => `${name} commande ce robot.`,
  ask: "Demander la commande",
  asking: "Demande en cours…",
  asked: "Demandé. Attendez la réponse.",
  wants: (name: string) => `${name} demande la commande de ce robot.`,
  give: "Donner",
  keep: "Garder",
  title: "Commande du robot",
  phoneName: "Nom de ce téléphone",
  phoneNameHint: "Les autres le voient quand vous commandez un robot.",
  save: "Enregistrer",
};

export const hold: Texts["hold"] = {
  mode: "Comment le bras doit-il bouger ?",
  modes: {
    held: {
      name: "Tant que j'appuie",
      detail: "quand vous lâchez, le bras s'arrête",
    },
    alone: { name: "Tout seul", detail: "une fois lancé, jusqu'à la fin" },
  },
  onlyHeld: "Ce robot ne bouge que tant que vous appuyez sur le bouton.",
  ready: "Préparer",
  gettingReady: "Préparation du bras…",
  nothingMoves: "Rien ne bouge encore : à la page suivante, vous maintenez un bouton appuyé.",
  button: "Maintenir pour bouger",
  holding: "En mouvement – lâchez pour arrêter",
  waits: "Le bras vous attend",
  keepClear: "Tenez-vous à l'écart. Le bras bouge tant que vous appuyez.",
  keys: "Au clavier : maintenez la barre d'espace appuyée.",
};
