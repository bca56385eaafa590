// What the live socket brings: the robot, and changes of everything else. Also the stop.
import { computed, signal } from "@preact/signals";
import type { LiveMessage, RobotView } from "../api/types";
import { stopAllRobots, stopRobot } from "../api/endpoints";
import type { ConnectionState } from "../live/connection";
import { JointRing } from "../live/ring-buffer";
import { LiveSocket } from "../live/socket";
import { inOurWords } from "../words";
import { ArmDrag, dragRefused } from "./arm-drag";
import { demonstrations, jobs, models, reproductions } from "./entities";
import { phoneId, phoneName } from "./phone";
import { keepRobot, lastKnown } from "./last-known";
import { robotId } from "./robots";

export const connection = signal<ConnectionState>("lost");
export const robot = signal<RobotView | null>(null);
/** Local time at which `robot` came in, for its age. */
export const robotAtMs = signal(0);
/** Counts the snapshots: screens load anew when it changes, so nothing missed stays unseen. */
export const snapshots = signal(0);
/** Advances a few times a second, for ages and elapsed times. */
export const nowMs = signal(Date.now());
/** Twelve seconds of joints at 25 Hz with room to spare. */
export const recentJoints = new JointRing(1024);

export const robotState = computed(() => robot.value?.state ?? null);
export const isVirtual = computed(() => robot.value?.kind === "virtual");

let socket: LiveSocket | null = null;
let watched = "";
let ticking = false;
let listening = false;

function tick(): void {
  if (!ticking) setInterval(() => (nowMs.value = Date.now()), 250);
  ticking = true;
}

/** Shows what this phone heard last, for a start without the server. */
export function showLastKnown(): void {
  const known = lastKnown(Date.now());
  if (known === null || robot.peek() !== null) return;
  robot.value = known.view;
  robotAtMs.value = known.atMs;
  nowMs.value = Date.now();
  tick();
}

/** Follows this robot; nothing of another one is shown any more. */
export function startLive(id: string): void {
  if (socket !== null && watched !== id) {
    socket.close();
    socket = null;
    robot.value = null;
    recentJoints.clear();
  }
  if (socket === null) {
    // What was known from an earlier day is no state to work with.
    robot.value = null;
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    const who = new URLSearchParams({ robot: id, phone: phoneId, phone_name: phoneName.peek() });
    socket = new LiveSocket(`${scheme}//${location.host}/api/v1/live?${who}`, {
      state: (state) => (connection.value = state),
      message: (message) => receive(inOurWords(message)),
    });
    watched = id;
  }
  tick();
  if (!listening) {
    listening = true;
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "visible") socket?.open();
    });
  }
  socket.open();
}

/** Stops the arm by both ways at once; either alone is enough. Settles well when the server has
 *  answered: what went into the socket may be lost without notice. As long as it is not known
 *  which arm is meant, all of them are stopped. */
export async function stop(): Promise<void> {
  socket?.send({ type: "stop" });
  const id = robotId.peek();
  await (id === "" ? stopAllRobots() : stopRobot(id));
}

/** Leads the virtual arm by its tool. */
export const armDrag = new ArmDrag(
  (message) => connection.peek() === "live" && (socket?.send(message) ?? false),
);

/** Says that the button is held at this moment; to be said again before 180 ms are over. `press`
 *  grows with every press: what the network kept back for long is over. Whether it could be said. */
export function hold(reproduction: string, press: number): boolean {
  return socket?.send({ type: "hold", reproduction, press }) ?? false;
}

/** Says that nobody holds the button any more; silence would mean the same a little later. */
export function letGo(): void {
  socket?.send({ type: "let_go" });
}

function receive(message: LiveMessage): void {
  switch (message.type) {
    case "snapshot":
      recentJoints.clear();
      takeRobot(message.robot);
      if (message.demonstration) demonstrations.put(message.demonstration);
      if (message.reproduction) reproductions.put(message.reproduction);
      jobs.put(...message.jobs);
      snapshots.value += 1;
      break;
    case "robot":
      takeRobot(message.robot);
      break;
    case "demonstration":
      demonstrations.put(message.demonstration);
      break;
    case "job":
      jobs.put(message.job);
      break;
    case "model":
      models.put(message.model);
      break;
    case "reproduction":
      reproductions.put(message.reproduction);
      break;
    case "drag_refused":
      dragRefused.value = message;
      armDrag.end();
      break;
  }
}

function takeRobot(view: RobotView): void {
  robot.value = view;
  robotAtMs.value = Date.now();
  keepRobot(view, robotAtMs.value);
  if (view.joints_deg) recentJoints.push((performance.now() - view.age_ms) / 1000, view.joints_deg);
}
