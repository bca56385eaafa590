// English words for the page with all robots of the cell.
export const robots = {
  title: "Robots",
  choose: "Press the robot that you stand at.",
  chooseFirst: "There are several robots. Press the one that you stand at.",
  change: (name: string) => `Robot ${name}. Choose another robot`,
  noJoints: "Where it stands is not known",
  jointsNow: "Joints measured just now",
  jointsAge: (age: string) => `Joints measured ${age} ago`,
  egmNever: "Control link: not used yet",
  egmOn: "on",
  egmOff: "resting",
  priority: "with priority",
  noPriority: "without priority",
  egm: (link: string, lost: number, late: number, priority: string) =>
    `Control link: ${link}, ${lost} lost, ${late} late, ${priority}`,
};
