// German words for the state of the robot and of the connection to it.
import type { Texts } from "..";

export const robot: Texts["robot"] = {
  bar: "Roboter",
  states: {
    disconnected: "Nicht verbunden",
    none: "Kein Roboter",
    idle: "Bereit",
    guiding: "Handführung an",
    reproducing: "Bewegt sich",
    stopping: "Stoppt",
    faulted: "Störung",
    unknown: "Noch unbekannt",
  },
  connecting: "Verbindet…",
  offline: "Offline",
  offlineWork:
    "Dieses Telefon ist offline. Was Sie sehen, ist alt. Sobald das Telefon wieder verbunden ist, geht es von selbst weiter.",
  now: "live",
  ago: (state: string, age: string) => `${state}, vor ${age}`,
  old: (age: string) => `alt: ${age}`,
  happened: "Was geschehen ist",
  todo: "Was zu tun ist",
  acknowledge: "Ich habe den Roboter geprüft",
  acknowledging: "Fragt den Roboter…",
  soft: {
    title: "Arm von Hand bewegen",
    explain:
      "Schalten Sie die Handführung ein, um den Arm an den Anfang zu bringen. Dabei wird nichts aufgenommen.",
    on: "Handführung einschalten",
    off: "Handführung ausschalten",
    turningOn: "Schaltet ein…",
    turningOff: "Schaltet aus…",
    isSoft:
      "Die Handführung ist an: Der Arm gibt nach, wenn Sie drücken. Schalten Sie sie aus, sobald der Arm richtig steht.",
    handBack: "Virtuelle Hand: an den Anfang bringen",
    handMoving: "Die virtuelle Hand bringt den Arm zurück…",
  },
  why: {
    disconnected: "Der Roboter ist nicht verbunden.",
    guiding: "Die Handführung ist an. Schalten Sie sie zuerst aus.",
    reproducing: "Der Arm bewegt sich.",
    stopping: "Der Arm hält gerade an.",
    faulted: "Es gibt eine Störung. Sehen Sie oben auf der Seite nach.",
    offline: "Dieses Telefon ist nicht mit dem Server verbunden.",
  },
};
