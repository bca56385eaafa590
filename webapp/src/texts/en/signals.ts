// English words about signals: the gripper and its like.
export const signals = {
  group: "Gripper and signals",
  press: (label: string, verb: string) => `${label}: ${verb}`,
  stands: (label: string, verb: string) => `${label} is now at “${verb}”.`,
  unknown: (label: string) => `Nobody knows how the ${label.toLowerCase()} stands.`,
  setting: (label: string) => `${label}…`,
  notWhileMoving: "The motion works it by itself.",
  recorded: "Worked while recording",
  planned: "Worked on the way",
  done: "Worked by the motion",
  at: (time: string) => `at ${time}`,
};
