// English words of teaching in one go: the next take, pause, cutting, pictures, undo, the verdict.

export const teaching = {
  keepAnother: "Keep, one more",
  keepTrain: "Keep and train",
  change: "Change",
  planning: "Planning the motion…",

  next: {
    wait: "The next take begins as soon as the arm is ready.",
    bringBack: "Bring the arm back to where the motion begins. It is soft now.",
    begins: "Recording begins in",
    now: "Record now",
    more: "10 s more",
    softening: "Making the arm soft…",
  },

  pause: {
    press: "Pause",
    pausing: "Pausing…",
    paused: "Paused",
    explain: "Nothing is recorded now. The arm is soft: hold it.",
    here: "The arm is where you paused. You can go on.",
    off: (joint: number, degrees: string) =>
      `Joint ${joint} is ${degrees} from where you paused. Bring the arm back there.`,
    unknown: "Where the arm is now is not known.",
    goOn: "Go on",
    goingOn: "Going on…",
    notHere: "Not there yet.",
    notHand: "The virtual hand can't be paused.",
    count: "Pauses",
  },

  trim: {
    title: "Cut the ends",
    explain: "Cut away what does not belong to the motion. Nothing is lost: you can take it back.",
    begins: "Begins at",
    ends: "Ends at",
    move: (end: string, step: string) => `${end}: ${step}`,
    save: "Cut",
    saving: "Cutting…",
    unchanged: "Move the beginning or the end first.",
    whole: "Whole take again",
    restoring: "Taking it back…",
    isCut: (before: string, after: string) =>
      `Cut away: ${before} at the beginning, ${after} at the end.`,
    stands: (before: string, after: string) =>
      `The arm stands still for ${before} at the beginning and ${after} at the end.`,
    standsFirst: (before: string) => `The arm stands still for ${before} at the beginning.`,
    standsLast: (after: string) => `The arm stands still for ${after} at the end.`,
    accept: "Cut that away",
    used: "Used",
    changedSince: "Takes were cut or chosen anew since this was trained. Train again to use that.",
  },

  picture: {
    title: "Picture",
    explain: "A picture helps to find the task without reading.",
    take: "Take a photo",
    choose: "Choose a picture",
    remove: "Remove the picture",
    removing: "Removing…",
    preparing: "Preparing the picture…",
    unreadable: "This file can't be shown as a picture.",
    chooseOther: "Choose another photo.",
  },

  undo: {
    press: "Undo",
    undoing: "Undoing…",
    kept: (take: number) => `Take ${take} is kept.`,
    discarded: (take: number) => `Take ${take} is discarded.`,
    deleted: (name: string) => `“${name}” is deleted.`,
  },

  verdict: {
    green: { word: "Good", sentence: "The arm does what you showed, and your takes agree." },
    amber: {
      word: "Usable with care",
      far: "The path is a little further from your takes than they are from each other.",
      few: "It is learned from one take: slips of your hand are in it.",
      disagree: "Your takes do not quite agree yet.",
    },
    red: {
      word: "Do not use",
      far: "The path is far from what you showed. Record the motion again.",
      goal: "The arm would miss the goal. Record the motion again.",
      shape: "The motion is not the one that you showed. Record it again.",
    },
    remarks: "Remarks",
  },
};
