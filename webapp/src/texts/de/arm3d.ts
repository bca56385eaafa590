// German words of the picture of the arm, and of leading the virtual arm in it.
import type { Texts } from "..";

export const arm3d: Texts["arm3d"] = {
  loading: "Das Bild wird geladen…",
  missing: "Dieses Telefon kann den Arm nicht als Bild zeigen. Kurven und Zahlen zeigen dasselbe.",
  tool: (forward, left, up) =>
    `Das Werkzeug ist ${forward} cm vor, ${left} cm links von und ${up} cm über dem Sockel.`,
  labels: {
    plan: "Der Arm auf seinem geplanten Weg. Der durchsichtige Arm steht am Ende der Bewegung.",
    flight: "Der Arm, wie er gemessen wurde. Der durchsichtige Arm steht, wo der Plan ihn hat.",
    take: "Die aufgenommene Bewegung des Arms.",
    live: "Der Arm, wie er jetzt steht.",
  },
  legend: {
    path: "Weg des Werkzeugs",
    approach: "Weg zum Anfang",
    band: "Streuung Ihrer Aufnahmen",
    ghostGoal: "Ende der Bewegung",
    ghostPlanned: "geplante Stellung",
    planned: "geplanter Weg",
  },
  view: {
    title: "Bild drehen",
    left: "Nach links",
    right: "Nach rechts",
    closer: "Näher",
    farther: "Weiter weg",
    front: "Vorn",
    side: "Seite",
    top: "Oben",
  },
  drag: {
    hint: "Legen Sie einen Finger auf die Kugel und bewegen Sie sie: Der Arm folgt.",
    buttons: "Mit Tasten bewegen",
    hold: "Halten Sie eine Taste gedrückt, um das Werkzeug zu bewegen.",
    up: "Hoch",
    down: "Runter",
    left: "Links",
    right: "Rechts",
    forward: "Weg von Ihnen",
    back: "Zu Ihnen",
    twistLeft: "Links drehen",
    twistRight: "Rechts drehen",
    tiltLeft: "Links kippen",
    tiltRight: "Rechts kippen",
    tiltBack: "Zu Ihnen kippen",
    tiltAway: "Von Ihnen weg kippen",
    lost: "Das Telefon ist nicht verbunden. Der Arm folgt jetzt nicht.",
  },
  lead: {
    who: "Wer führt den virtuellen Arm?",
    name: "Ich führe ihn selbst",
    detail: "mit dem Finger, im Bild des Arms",
    steps: [
      "Hier ist kein echter Roboter: Sie führen den virtuellen Arm in seinem Bild.",
      "Drücken Sie Aufnehmen. Nach 3, 2, 1 ist die Handführung an.",
      "Bewegen Sie die Kugel am Werkzeug mit dem Finger. Drücken Sie dann Aufnahme beenden.",
    ],
  },
};
