// English words about which phone controls the robot, and about holding the button.
export const control = {
  nameless: (end: string) => `Phone ${end}`,
  other: (name: string) => `${name} controls this robot.`,
  ask: "Ask for control",
  asking: "Asking…",
  asked: "Asked. Wait for the answer.",
  wants: (name: string) => `${name} asks for control of this robot.`,
  give: "Give",
  keep: "Keep",
  title: "Control of the robot",
  phoneName: "Name of this phone",
  phoneNameHint: "Others see it when you control a robot.",
  save: "Save",
};

export const hold = {
  mode: "How shall it run?",
  modes: {
    held: { name: "While I hold the button", detail: "let go, and the arm stands still" },
    alone: { name: "By itself", detail: "once started, until the end" },
  },
  onlyHeld: "This robot moves only while you hold the button.",
  ready: "Get ready",
  gettingReady: "Getting the arm ready…",
  nothingMoves: "Nothing moves yet: on the next page you hold a button.",
  button: "Hold to move",
  holding: "Moving – let go to stop",
  waits: "The arm waits for you",
  keepClear: "Keep clear of the arm. It moves while you hold the button.",
  keys: "With a keyboard: hold the space bar.",
};
