// What a person chose for a run, per task, kept while the app is open; and the plan made from it.
import { signal } from "@preact/signals";
import { makePlan, planWayBack } from "../api/endpoints";
import type { Placement, Plan, PlanRequest } from "../api/types";
import { readJoints } from "../format/joint-ranges";
import { fixed } from "../format/numbers";
import { robot } from "./live";
import { robotId } from "./robots";

export type GoalChoice = "as_taught" | "present" | "saved" | "typed";
export type StartChoice = "as_taught" | "present" | "saved";
export const SPEEDS = ["0.25", "0.5", "1"] as const;
export type Speed = (typeof SPEEDS)[number];

/** Whether the arm moves only while the button is held. */
export type RunMode = "held" | "alone";

export interface RunSetup {
  goal: GoalChoice;
  /** The six typed joint angles, as typed. */
  typed: string[];
  start: StartChoice;
  /** The saved positions that are chosen, by id. */
  goalPosition?: string;
  startPosition?: string;
  speed: Speed;
  mode: RunMode;
}

/** Slow is where everyone begins: a new motion is watched before it is let go. */
const FRESH: RunSetup = {
  goal: "as_taught",
  typed: [],
  start: "as_taught",
  speed: "0.25",
  mode: "held",
};

const setups = signal<ReadonlyMap<string, RunSetup>>(new Map());
const plans = signal<ReadonlyMap<string, Plan>>(new Map());

export function setupOf(task: string): RunSetup {
  return setups.value.get(task) ?? FRESH;
}

export function change(task: string, changed: Partial<RunSetup>): void {
  setups.value = new Map(setups.peek()).set(task, { ...setupOf(task), ...changed });
}

/** Whether the arm will move only while the button is held: always where it may not run alone. */
export function isHeld(task: string): boolean {
  return !robot.value?.continuous_run || setupOf(task).mode === "held";
}

export function planOf(task: string): Plan | undefined {
  const plan = plans.value.get(task);
  // A plan is for one robot; the choices above are for any.
  return plan?.robot === robotId.value ? plan : undefined;
}

/** The choices as a request; null while a typed number is missing or wrong, or a saved position is
 *  still to be chosen. */
export function planRequest(model: string, setup: RunSetup): PlanRequest | null {
  const goal = placement(setup.goal, setup.goalPosition, setup.typed);
  const start = placement(setup.start, setup.startPosition, []);
  if (goal === null || start === null) return null;
  return { model_id: model, start, goal, speed: Number(setup.speed) };
}

function placement(
  choice: GoalChoice,
  position: string | undefined,
  typed: readonly string[],
): Placement | null {
  if (choice === "saved") return position === undefined ? null : { position };
  if (choice !== "typed") return choice;
  const joints = readJoints(typed);
  return joints && { joints_deg: joints };
}

/** Whether a saved position is still to be chosen. */
export function lacksPosition(setup: RunSetup): boolean {
  return (
    (setup.goal === "saved" && setup.goalPosition === undefined) ||
    (setup.start === "saved" && setup.startPosition === undefined)
  );
}

/** Asks the server for the motion and keeps it for the preview. */
export async function preview(task: string, model: string): Promise<void> {
  const request = planRequest(model, setupOf(task));
  if (request === null) return;
  const plan = await makePlan({ ...request, robot: robotId.peek() });
  plans.value = new Map(plans.peek()).set(task, plan);
}

/** Asks for the motion as it was taught, whatever was chosen for an earlier run. */
export async function previewAsTaught(task: string, model: string): Promise<void> {
  change(task, { goal: "as_taught", start: "as_taught" });
  await preview(task, model);
}

/** Asks for the way back of a motion that was stopped and keeps it for the preview. */
export async function previewWayBack(task: string, motion: string): Promise<void> {
  const plan = await planWayBack(motion);
  plans.value = new Map(plans.peek()).set(task, plan);
}

/** Joint angles as text to start typing from. */
export function asTyped(joints: readonly number[]): string[] {
  return joints.map((value) => fixed(value, 1).replace("−", "-"));
}
