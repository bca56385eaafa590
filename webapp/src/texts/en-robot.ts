// English words for the state of the robot and of the connection to it.
export const robot = {
  bar: "Robot",
  states: {
    disconnected: "No robot",
    idle: "Ready",
    guiding: "Arm is soft",
    reproducing: "Moving",
    stopping: "Stopping",
    faulted: "Fault",
    unknown: "Not known yet",
  },
  connecting: "Connecting…",
  offline: "Offline",
  offlineWork:
    "This phone is offline. What is shown is old; it goes on by itself when the phone is back.",
  now: "live",
  ago: (state: string, age: string) => `${state}, ${age} ago`,
  old: (age: string) => `old: ${age}`,
  happened: "What happened",
  todo: "What to do",
  acknowledge: "I have checked the robot",
  acknowledging: "Asking the robot…",
  soft: {
    title: "Move the arm by hand",
    explain: "Make the arm soft to bring it back to the start, without recording.",
    on: "Make the arm soft",
    off: "Make the arm stiff",
    turningOn: "Switching to soft…",
    turningOff: "Switching to stiff…",
    isSoft:
      "The arm is soft now and moves when you push it. Make it stiff when it stands where you want it.",
    handBack: "Virtual hand: bring it to the start",
    handMoving: "The virtual hand brings the arm back…",
  },
  why: {
    disconnected: "The robot is not connected.",
    guiding: "The arm is soft. Make it stiff first.",
    reproducing: "The arm is moving.",
    stopping: "The arm is stopping.",
    faulted: "There is a fault. Look at the top of the page.",
    offline: "This phone is not connected to the server.",
  },
};
