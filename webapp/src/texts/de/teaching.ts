// German words of teaching in one go: the next take, pause, cutting, pictures, undo, the verdict.
import type { Texts } from "..";

export const teaching: Texts["teaching"] = {
  keepAnother: "Behalten, noch eine",
  keepTrain: "Behalten und trainieren",
  change: "Ändern",
  planning: "Bewegung wird geplant…",

  next: {
    wait: "Die nächste Aufnahme beginnt, sobald der Arm bereit ist.",
    bringBack: "Bringen Sie den Arm zum Anfang der Bewegung zurück. Die Handführung ist an.",
    begins: "Aufnahme beginnt in",
    now: "Jetzt aufnehmen",
    more: "Noch 10 s",
    softening: "Handführung wird eingeschaltet…",
  },

  pause: {
    press: "Pause",
    pausing: "Wird angehalten…",
    paused: "Pause",
    explain: "Jetzt wird nichts aufgenommen. Die Handführung ist an: Halten Sie den Arm.",
    here: "Der Arm ist dort, wo Sie angehalten haben. Es kann weitergehen.",
    off: (joint, degrees) =>
      `Achse ${joint} ist ${degrees} von der Stelle der Pause entfernt. Bringen Sie den Arm dorthin zurück.`,
    unknown: "Wo der Arm jetzt ist, ist nicht bekannt.",
    goOn: "Weiter",
    goingOn: "Geht weiter…",
    notHere: "Noch nicht dort.",
    notHand: "Die virtuelle Hand kann nicht angehalten werden.",
    count: "Pausen",
  },

  trim: {
    title: "Enden abschneiden",
    explain:
      "Schneiden Sie ab, was nicht zur Bewegung gehört. Nichts geht verloren: Sie können es zurücknehmen.",
    begins: "Beginnt bei",
    ends: "Endet bei",
    move: (end, step) => `${end}: ${step}`,
    save: "Abschneiden",
    saving: "Wird abgeschnitten…",
    unchanged: "Verschieben Sie zuerst den Anfang oder das Ende.",
    whole: "Wieder die ganze Aufnahme",
    restoring: "Wird zurückgenommen…",
    isCut: (before, after) => `Abgeschnitten: ${before} am Anfang, ${after} am Ende.`,
    stands: (before, after) => `Der Arm steht am Anfang ${before} und am Ende ${after} still.`,
    standsFirst: (before) => `Der Arm steht am Anfang ${before} still.`,
    standsLast: (after) => `Der Arm steht am Ende ${after} still.`,
    accept: "Das abschneiden",
    used: "Verwendet",
    changedSince:
      "Seit diesem Training wurden Aufnahmen geschnitten oder anders gewählt. Trainieren Sie neu, um das zu verwenden.",
  },

  picture: {
    title: "Bild",
    explain: "Mit einem Bild findet man die Aufgabe, ohne zu lesen.",
    take: "Foto aufnehmen",
    choose: "Bild wählen",
    remove: "Bild entfernen",
    removing: "Wird entfernt…",
    preparing: "Bild wird vorbereitet…",
    unreadable: "Diese Datei kann nicht als Bild gezeigt werden.",
    chooseOther: "Wählen Sie ein anderes Foto.",
  },

  undo: {
    press: "Rückgängig",
    undoing: "Wird zurückgenommen…",
    kept: (take) => `Aufnahme ${take} ist behalten.`,
    discarded: (take) => `Aufnahme ${take} ist verworfen.`,
    deleted: (name) => `„${name}“ ist gelöscht.`,
  },

  verdict: {
    green: {
      word: "Gut",
      sentence: "Der Arm macht, was Sie gezeigt haben, und Ihre Aufnahmen stimmen überein.",
    },
    amber: {
      word: "Mit Vorsicht verwendbar",
      far: "Der Weg liegt etwas weiter von Ihren Aufnahmen entfernt als diese voneinander.",
      few: "Gelernt aus einer einzigen Aufnahme: Ausrutscher der Hand sind mit drin.",
      disagree: "Ihre Aufnahmen stimmen noch nicht ganz überein.",
    },
    red: {
      word: "Nicht verwenden",
      far: "Der Weg liegt weit von dem entfernt, was Sie gezeigt haben. Nehmen Sie die Bewegung neu auf.",
      goal: "Der Arm würde das Ziel verfehlen. Nehmen Sie die Bewegung neu auf.",
      shape: "Das ist nicht die Bewegung, die Sie gezeigt haben. Nehmen Sie sie neu auf.",
    },
    remarks: "Bemerkungen",
  },
};
